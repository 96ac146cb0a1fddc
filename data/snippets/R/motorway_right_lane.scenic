# component: R
# description: A motorway carriageway of two or more lanes without oncoming traffic; ego is in the rightmost lane.
# paraphrases:
#   - divided highway, slow lane
#   - interstate, keep to the right
# places: [motorway]
# ego_lanes: [rightmost]
# ---
carriageways = filter(lambda g: g.road.is1Way and not g._sidewalk and len(g.lanes) >= 2 and g.lanes[0].centerline.length > 500, network.laneGroups)
carriageway = Uniform(*carriageways)
egoLane = carriageway.lanes[0]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(200), facing roadDirection
