# component: R
# description: Ego turns left at a three-way intersection without lights.
# paraphrases:
#   - leave the through road to the left at an unsignalised T
#   - left into the minor road at a three-arm junction
# places: [intersection]
# manoeuvres: [left]
# controls: [none]
# ---
teeTurns = [m for i in network.intersections if i.is3Way and not i.isSignalized for m in i.maneuvers if m.type is ManeuverType.LEFT_TURN]
egoManeuver = Uniform(*teeTurns)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -25
