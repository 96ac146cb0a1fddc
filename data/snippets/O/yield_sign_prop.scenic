# component: O
# description: A yield sign stands at the right of ego's lane before the junction.
# paraphrases:
#   - give-way sign on the approach
#   - a sign tells me to give way
#   - a yield sign at the junction in front of me
# positions: [roadside]
# actions: [stationary]
# types: [yield_sign]
# ---
yieldSignPoint = egoLane.centerline.pointAlongBy(egoLane.centerline.length - 4)
yieldSignSpot = new OrientedPoint at yieldSignPoint, facing roadDirection
yieldSign = new TrafficWarning right of yieldSignSpot by 3, facing 180 deg relative to yieldSignSpot.heading,
    with rolename 'yield_sign', with regionContainedIn None
