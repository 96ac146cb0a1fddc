# component: R
# description: A road with a shoulder or parking lane beside ego's lane, so that vehicles can stand at the kerb.
# paraphrases:
#   - a street lined with parking bays on the near side
#   - there is room to park right of the driving lane
#   - room for parked cars at the side
# places: [road]
# ---
kerbside = filter(lambda g: g._shoulder is not None and g.lanes[0].centerline.length > 180, network.laneGroups)
egoGroup = Uniform(*kerbside)
egoLane = egoGroup.lanes[0]
parkingStrip = egoGroup.shoulder
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(50), facing roadDirection
