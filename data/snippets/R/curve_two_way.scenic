# component: R
# description: A bend of a two-way road with the oncoming lane on the inside or outside of it.
# paraphrases:
#   - curved country road with opposing traffic
#   - blind bend, vehicles may come round it
#   - a bendy road out in the country
# places: [curve]
# ---
def sinuous(lane):
    return lane.centerline.length > 1.01 * lane.centerline[0].distanceTo(lane.centerline[-1])
bends = filter(lambda g: g._opposite is not None and sinuous(g.lanes[0]) and g.lanes[0].centerline.length > 300, network.laneGroups)
bendGroup = Uniform(*bends)
egoLane = bendGroup.lanes[0]
oncomingLane = bendGroup.opposite.lanes[0]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(60), facing roadDirection
