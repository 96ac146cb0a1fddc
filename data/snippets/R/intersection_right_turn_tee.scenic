# component: R
# description: Ego turns right at a three-way intersection.
# paraphrases:
#   - turn right at the T-junction
#   - turn right where the road ends at another
#   - right turn at a junction of three roads
# places: [intersection]
# manoeuvres: [right]
# ---
teeJunctions = filter(lambda i: i.is3Way and any(m.type is ManeuverType.RIGHT_TURN for m in i.maneuvers), network.intersections)
junction = Uniform(*teeJunctions)
egoManeuver = Uniform(*filter(lambda m: m.type is ManeuverType.RIGHT_TURN, junction.maneuvers))
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -25
