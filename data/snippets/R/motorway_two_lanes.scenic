# component: R
# description: 'A two-lane motorway carriageway: exactly two lanes in the direction of travel.'
# paraphrases:
#   - dual carriageway, two lanes each way with a barrier between
#   - a highway with two lanes
#   - a freeway with two lanes going my way
# places: [motorway]
# ---
twoLane = filter(lambda r: r.is1Way and len(r.lanes) == 2 and r.lanes[0].centerline.length > 700, network.roads)
motorwayRoad = Uniform(*twoLane)
egoLane = Uniform(*motorwayRoad.lanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(300), facing roadDirection
