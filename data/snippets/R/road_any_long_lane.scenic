# component: R
# description: Ego starts on any ordinary road lane that runs on for at least 150 metres.
# paraphrases:
#   - somewhere on a normal street with plenty of room ahead
#   - an arbitrary stretch of carriageway, no junction near
# places: [road]
# ---
roomyLanes = filter(lambda lane: lane.centerline.length > 220, network.lanes)
egoLane = Uniform(*roomyLanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(60), facing roadDirection
