# component: R
# description: Ego is on a single-lane ramp that merges into a carriageway of three or more lanes.
# paraphrases:
#   - join the motorway from the slip road
#   - highway entry by an acceleration lane
#   - slip road that leads onto the highway
# places: [on_ramp]
# ---
merges = [m for i in network.intersections for m in i.maneuvers if m.startLane.road.is1Way and len(m.startLane.road.lanes) == 1]
entries = filter(lambda m: m.endLane.road.is1Way and len(m.endLane.road.lanes) >= 3, merges)
egoManeuver = Uniform(*entries)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -120
