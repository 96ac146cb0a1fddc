# component: R
# description: Ego approaches a four-way intersection and will go straight over it.
# paraphrases:
#   - crossroads with four arms, continue ahead
#   - drive straight across a four-legged junction
# places: [intersection]
# manoeuvres: [straight]
# ---
fourWays = filter(lambda i: i.is4Way, network.intersections)
junction = Uniform(*fourWays)
egoManeuver = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers))
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -40
