# component: R
# description: A road with at least two lanes in ego's direction; ego is in the right one.
# paraphrases:
#   - dual-lane carriageway with the subject vehicle on the outer side
#   - two lanes going the same way, host keeps to the slow one
# places: [road]
# ego_lanes: [rightmost]
# ---
pairs = [g for g in network.laneGroups if len(g.lanes) >= 2 and g.lanes[0].centerline.length > 220]
egoGroup = Uniform(*pairs)
egoLane = egoGroup.lanes[0]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(70), facing roadDirection
