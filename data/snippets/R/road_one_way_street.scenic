# component: R
# description: 'A one-way street: every lane of the road leads in ego''s direction.'
# paraphrases:
#   - road where nobody may come the other way
#   - single-direction street in town
# places: [road]
# ---
oneWay = [r for r in network.roads if r.is1Way and r.lanes[0].centerline.length > 200]
egoRoad = Uniform(*oneWay)
egoLane = Uniform(*egoRoad.lanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(80), facing roadDirection
