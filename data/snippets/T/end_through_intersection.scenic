# component: T
# description: The run ends when ego is 10 metres behind the intersection.
# paraphrases:
#   - finish after the junction is crossed
#   - end after crossing the junction
#   - over when my car is past the crossroads
# conditions: [travelled, action]
# hosts: [R/intersection_four_way]
# ---
exitLine = new OrientedPoint following roadDirection from egoManeuver.endLane.centerline[0] for 10
terminate when (distance past exitLine of ego) > 0 and (distance from ego to exitLine) < 20
