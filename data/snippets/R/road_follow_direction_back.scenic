# component: R
# description: The spot for ego lies 100 metres before the end of its lane, found by going back along the road direction.
# paraphrases:
#   - place the test vehicle a fixed way before the lane's end
#   - some way before the road ends
#   - a fixed stretch before the end of the lane
# places: [road]
# ---
longLanes = filter(lambda l: l.centerline.length > 200, network.lanes)
egoLane = Uniform(*longLanes)
laneEnd = egoLane.centerline[-1]
egoSpot = new OrientedPoint following roadDirection from laneEnd for -100
