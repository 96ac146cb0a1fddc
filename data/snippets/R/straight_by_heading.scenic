# component: R
# description: 'A straight road: the direction changes by less than 5 degrees over the next 150 metres.'
# paraphrases:
#   - dead straight stretch without bends
#   - level straight test track
#   - no bend at all in front
# places: [straight]
# ---
candidates = filter(lambda lane: lane.centerline.length > 300, network.lanes)
egoLane = Uniform(*candidates)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(60), facing roadDirection
farSpot = new OrientedPoint following roadDirection from egoSpot for 150
require abs(relative heading of farSpot from egoSpot) < 5 deg
