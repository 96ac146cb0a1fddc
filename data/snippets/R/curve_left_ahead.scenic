# component: R
# description: 'A bend to the left: the road''s heading turns by over 20 degrees to the left within 100 metres.'
# paraphrases:
#   - ego is about to enter a left-hand curve
#   - the road sweeps round to the left ahead
# places: [curve]
# ---
longLanes = filter(lambda lane: lane.centerline.length > 400, network.lanes)
egoLane = Uniform(*longLanes)
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
beyondBend = new OrientedPoint following roadDirection from egoSpot for 100
require (relative heading of beyondBend from egoSpot) > 20 deg
require (distance from egoSpot to egoLane.centerline[-1]) > 150
