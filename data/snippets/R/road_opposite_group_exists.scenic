# component: R
# description: Any road that has lanes of the other direction, picked by its opposite lane group.
# paraphrases:
#   - street with traffic in both directions
#   - a road with oncoming traffic
#   - a two-way road
# places: [road]
# ---
twoWay = filter(lambda lane: lane.group._opposite is not None and lane.centerline.length > 180, network.lanes)
egoLane = Uniform(*twoWay)
opposingLane = Uniform(*egoLane.group.opposite.lanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(50), facing roadDirection
