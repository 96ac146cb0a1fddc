# component: R
# description: 'A bend to the right: the road''s heading turns by over 20 degrees to the right within 100 metres.'
# paraphrases:
#   - a right-hand curve lies in front of the car
#   - road veers off to the right
# places: [curve]
# ---
bendLanes = [lane for lane in network.lanes if lane.centerline.length > 400]
egoLane = Uniform(*bendLanes)
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
afterBend = new OrientedPoint following roadDirection from egoSpot for 100
require (relative heading of egoSpot from afterBend) > 20 deg
require (distance from afterBend to egoLane.centerline[-1]) > 50
