# component: R
# description: Ego turns right at an intersection with traffic lights.
# paraphrases:
#   - right on red or green at a signal-controlled crossing
#   - turn right at the traffic lights
#   - right turn at a light
# places: [intersection]
# manoeuvres: [right]
# controls: [signal]
# ---
signalised = filter(lambda i: i.isSignalized, network.intersections)
junction = Uniform(*signalised)
egoManeuver = Uniform(*filter(lambda m: m.type is ManeuverType.RIGHT_TURN, junction.maneuvers))
egoLane = egoManeuver.startLane
egoPath = [egoLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(egoLane.centerline.length - 30), facing roadDirection
