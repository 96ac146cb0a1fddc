# component: R
# description: A straight road with no intersection within 200 metres of ego's start.
# paraphrases:
#   - uninterrupted straight road, far from any crossing
#   - a long straight road with no crossing
#   - straight ahead for a long way, no side roads
# places: [straight]
# ---
def isStraight(lane):
    return lane.centerline.length - lane.centerline[0].distanceTo(lane.centerline[-1]) < 0.3
egoLane = Uniform(*[l for l in network.lanes if l.centerline.length > 450 and isStraight(l)])
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
require (distance from egoSpot to egoLane.centerline[-1]) > 200
require (distance from egoSpot to egoLane.centerline[0]) > 60
