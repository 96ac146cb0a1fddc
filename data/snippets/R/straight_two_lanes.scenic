# component: R
# description: A straight road with two or more lanes in ego's direction, ego on the right.
# paraphrases:
#   - multi-lane straight, keep right
#   - a straight road with two lanes going my way
#   - a straight multi-lane road
# places: [straight]
# ego_lanes: [rightmost]
# ---
def bend(lane):
    return lane.centerline.length - lane.centerline[0].distanceTo(lane.centerline[-1])
straightGroups = filter(lambda g: len(g.lanes) > 1 and bend(g.lanes[0]) < 0.3 and g.lanes[0].centerline.length > 300, network.laneGroups)
egoGroup = Uniform(*straightGroups)
egoLane = egoGroup.lanes[0]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(100), facing roadDirection
