# component: O
# description: A stop sign stands at the right before the intersection, facing ego.
# paraphrases:
#   - octagonal sign at the junction
#   - halt sign on the approach
#   - a stop sign at the junction in front of me
# positions: [roadside]
# actions: [stationary]
# types: [stop_sign]
# ---
stopSignSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -3
stopSign = new TrafficWarning right of stopSignSpot by 3, facing 180 deg relative to stopSignSpot.heading,
    with rolename 'stop_sign', with regionContainedIn None
