# component: R
# description: Ego approaches a signalised four-way intersection and goes straight on.
# paraphrases:
#   - crossroads with traffic lights
#   - drive up to a junction controlled by signals
#   - a junction with traffic lights
# places: [intersection]
# manoeuvres: [straight]
# controls: [signal]
# ---
signalised = filter(lambda i: i.isSignalized and i.is4Way, network.intersections)
junction = Uniform(*signalised)
egoManeuver = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers))
egoLane = egoManeuver.startLane
egoPath = [egoLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -45
