# component: R
# description: A roundabout found by its short one-way ring roads; ego comes from one of the roads that feed it.
# paraphrases:
#   - circular intersection, drive in from outside
#   - ego heads for a roundabout
#   - drive into a roundabout
# places: [roundabout]
# ---
ringRoads = filter(lambda r: r.is1Way and len(r.lanes) == 1 and r.lanes[0].centerline.length < 60, network.roads)
entries = [m for i in network.intersections for m in i.maneuvers if m.endLane.road in ringRoads and m.startLane.road not in ringRoads]
entry = Uniform(*entries)
egoLane = entry.startLane
egoPath = [entry.startLane, entry.connectingLane, entry.endLane]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(egoLane.centerline.length - 50), facing roadDirection
