# component: R
# description: Ego stands at the stop line, five metres before the junction begins.
# paraphrases:
#   - waiting at the entry of the crossing
#   - first in the queue at the junction
# places: [intersection]
# ---
junctionWays = [m for i in network.intersections if i.is4Way for m in i.maneuvers]
egoManeuver = Uniform(*junctionWays)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
stopLine = egoLane.centerline[-1]
egoSpot = new OrientedPoint following roadDirection from stopLine for -5
