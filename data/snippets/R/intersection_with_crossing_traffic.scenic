# component: R
# description: A crossroads at which ego goes straight and another manoeuvre crosses its path from the side.
# paraphrases:
#   - junction with conflicting cross traffic
#   - straight crossing paths at an intersection
# places: [intersection]
# manoeuvres: [straight]
# ---
over = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.STRAIGHT]
crossing = Uniform(*[(m, c) for m in over for c in m.conflictingManeuvers if c.type is ManeuverType.STRAIGHT and c.startLane.road is not m.startLane.road])
egoManeuver, sideManeuver = crossing[0], crossing[1]
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -35
