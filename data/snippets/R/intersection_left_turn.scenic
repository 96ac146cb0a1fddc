# component: R
# description: Ego turns left at a four-way intersection.
# paraphrases:
#   - take the left road at the crossroads
#   - the car under test makes a left at the junction
# places: [intersection]
# manoeuvres: [left]
# ---
leftTurns = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.LEFT_TURN]
egoManeuver = Uniform(*leftTurns)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -30
