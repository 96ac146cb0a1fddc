# component: O
# description: A speed limit sign of 30 km/h stands at the roadside.
# paraphrases:
#   - thirty zone sign by the lane
#   - posted limit ahead
#   - a sign says thirty
#   - a speed sign at the side of the road
# positions: [roadside]
# actions: [stationary]
# types: [speed_sign]
# ---
speedSignSpot = new OrientedPoint following roadDirection from egoSpot for 20
speedSign = new TrafficWarning right of speedSignSpot by 3, facing 180 deg relative to speedSignSpot.heading,
    with rolename 'speed_sign', with regionContainedIn None
