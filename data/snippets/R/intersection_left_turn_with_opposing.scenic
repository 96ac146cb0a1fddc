# component: R
# description: Ego turns left across a lane on which oncoming traffic goes straight (the conflicting manoeuvre is given too).
# paraphrases:
#   - unprotected left turn against opposite traffic
#   - left turn across path, opposite direction
# places: [intersection]
# manoeuvres: [left]
# ---
leftTurns = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.LEFT_TURN]
crossed = [m for m in leftTurns if any(c.type is ManeuverType.STRAIGHT for c in m.conflictingManeuvers)]
egoManeuver = Uniform(*crossed)
opposing = Uniform(*filter(lambda c: c.type is ManeuverType.STRAIGHT, egoManeuver.conflictingManeuvers))
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -30
