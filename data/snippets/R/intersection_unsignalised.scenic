# component: R
# description: Ego goes straight over a four-way intersection that has no traffic lights.
# paraphrases:
#   - uncontrolled crossroads, no signals
#   - junction without lights, priority by rule
# places: [intersection]
# manoeuvres: [straight]
# controls: [none]
# ---
quiet = [i for i in network.intersections if i.is4Way and not i.isSignalized]
junction = Uniform(*quiet)
egoManeuver = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers))
egoLane = egoManeuver.startLane
egoPath = [egoLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -Range(30, 45)
