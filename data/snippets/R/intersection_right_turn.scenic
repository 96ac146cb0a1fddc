# component: R
# description: Ego turns right at an intersection, whatever its number of arms.
# paraphrases:
#   - nearside turn into the side street
#   - right-hand turn at a junction
# places: [intersection]
# manoeuvres: [right]
# ---
rightTurns = [m for i in network.intersections for m in i.maneuvers if m.type is ManeuverType.RIGHT_TURN]
egoManeuver = Uniform(*[m for m in rightTurns if m.startLane.centerline.length > 70])
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -30
