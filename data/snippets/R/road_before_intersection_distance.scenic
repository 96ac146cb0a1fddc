# component: R
# description: Ego starts so that the nearest intersection is between 50 and 80 metres away along its lane.
# paraphrases:
#   - junction coming up at a given distance
#   - a road that comes to a junction soon
#   - the crossroads is not far ahead
# places: [intersection]
# ---
approach = [lane for lane in network.lanes if lane.maneuvers and lane.maneuvers[0].intersection and lane.centerline.length > 150]
egoLane = Uniform(*approach)
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
require 50 < (distance from egoSpot to egoLane.centerline[-1]) < 80
