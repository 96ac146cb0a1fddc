# component: R
# description: Ego goes straight on at a T-intersection along the through road.
# paraphrases:
#   - a side road joins, but the car continues ahead
#   - three-legged junction, main road
# places: [intersection]
# manoeuvres: [straight]
# ---
tees = filter(lambda i: i.is3Way, network.intersections)
junction = Uniform(*filter(lambda i: len(i.maneuvers) >= 6, tees))
egoManeuver = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers))
egoLane = egoManeuver.startLane
egoPath = [egoLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -35
