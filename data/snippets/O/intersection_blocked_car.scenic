# component: O
# description: A car stands in the lane that ego enters behind the intersection.
# paraphrases:
#   - exit of the junction is blocked
#   - stalled vehicle just after the crossing
#   - a car blocks the way out of the junction
# positions: [intersection_exit]
# actions: [stationary]
# types: [car]
# hosts: [R/intersection_four_way]
# ---
exitSpot = new OrientedPoint following roadDirection from egoManeuver.endLane.centerline[0] for Range(8, 14)
exitCar = new Car at exitSpot, facing roadDirection
