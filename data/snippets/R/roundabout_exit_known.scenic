# component: R
# description: A roundabout entry whose ring lane has an exit ahead, so that ego can circulate and leave.
# paraphrases:
#   - go into the rotary and take the next way out
#   - through the roundabout
# places: [roundabout]
# ---
entries = [m for i in network.intersections for m in i.maneuvers if m.endLane.road.is1Way and not m.startLane.road.is1Way]
leaving = filter(lambda m: any(not n.endLane.road.is1Way for n in m.endLane.maneuvers), entries)
egoManeuver = Uniform(*leaving)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -30
