# component: R
# description: Ego starts at a random point of a lane's centre line, at least 120 metres before the lane ends.
# paraphrases:
#   - anywhere along a street, as long as there is road left in front
#   - random location on the road network with free road ahead
# places: [road]
# ---
egoLane = Uniform(*[lane for lane in network.lanes if lane.centerline.length > 250])
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
require (distance from egoSpot to egoLane.centerline[-1]) > 120
