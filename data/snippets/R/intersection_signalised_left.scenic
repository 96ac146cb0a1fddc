# component: R
# description: Ego turns left at an intersection with traffic lights.
# paraphrases:
#   - left turn at the lights
#   - signal-controlled junction, turning off to the left
# places: [intersection]
# manoeuvres: [left]
# controls: [signal]
# ---
lights = [m for i in network.intersections if i.isSignalized for m in i.maneuvers if m.type is ManeuverType.LEFT_TURN]
egoManeuver = Uniform(*lights)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(egoLane.centerline.length - 35), facing roadDirection
