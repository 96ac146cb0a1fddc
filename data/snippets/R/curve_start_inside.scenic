# component: R
# description: 'Ego already drives in a bend: 15 metres behind it and 15 metres before it the headings differ.'
# paraphrases:
#   - right in the middle of a curve at the start
#   - my car starts in the middle of a bend
#   - already driving through a curve
# places: [curve]
# ---
egoLane = Uniform(*[lane for lane in network.lanes if lane.centerline.length > 400])
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
inFront = new OrientedPoint following roadDirection from egoSpot for 15
atBack = new OrientedPoint following roadDirection from egoSpot for -15
require abs(relative heading of inFront from atBack) > 8 deg
require (distance from egoSpot to egoLane.centerline[-1]) > 100
