# component: R
# description: A motorway carriageway; ego is in the leftmost, the overtaking lane.
# paraphrases:
#   - fast lane of an expressway
#   - passing lane on a divided highway
# places: [motorway]
# ego_lanes: [leftmost]
# ---
carriageways = [g for g in network.laneGroups if g._opposite is None and not g._sidewalk and len(g.lanes) >= 2]
carriageway = Uniform(*[g for g in carriageways if g.lanes[0].centerline.length > 500])
egoLane = carriageway.lanes[-1]
egoSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
require 100 < (distance from egoSpot to egoLane.centerline[0])
require 300 < (distance from egoSpot to egoLane.centerline[-1])
