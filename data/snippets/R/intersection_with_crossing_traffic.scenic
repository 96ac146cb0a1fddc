# component: R
# description: A crossroads at which ego goes straight and another manoeuvre crosses its path from the side.
# paraphrases:
#   - junction with conflicting cross traffic
#   - straight crossing paths at an intersection
# places: [intersection]
# manoeuvres: [straight]
# ---
crossable = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.STRAIGHT]
egoManeuver = Uniform(*crossable)
sideManeuver = Uniform(*filter(lambda c: c.type is ManeuverType.STRAIGHT and c.startLane.road is not egoManeuver.startLane.road, egoManeuver.conflictingManeuvers))
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -35
