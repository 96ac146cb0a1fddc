# component: R
# description: A road whose lane group has a sidewalk beside it on the near side.
# paraphrases:
#   - pavement for people on foot along ego's lane
#   - footpath next to the carriageway
# places: [road]
# ---
walkable = [g for g in network.laneGroups if g._sidewalk and g.lanes[0].centerline.length > 180]
nearGroup = Uniform(*walkable)
egoLane = nearGroup.lanes[0]
nearSidewalk = nearGroup.sidewalk
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(Range(40, 70)), facing roadDirection
