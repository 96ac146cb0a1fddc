# component: R
# description: 'Ego approaches a roundabout: a way from a two-way road into a single one-way ring lane.'
# paraphrases:
#   - enter the traffic circle
#   - rotary with circulating traffic
#   - drive into a roundabout
# places: [roundabout]
# ---
ringEntries = [m for i in network.intersections for m in i.maneuvers if m.endLane.road.is1Way and len(m.endLane.road.lanes) == 1 and not m.startLane.road.is1Way]
egoManeuver = Uniform(*ringEntries)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -40
