# component: R
# description: A straight lane, chosen because its chord is as long as its centre line.
# paraphrases:
#   - lane with no curvature from start to end
#   - road segment that does not bend
#   - a road as straight as a ruler
# places: [straight]
# ---
def isStraight(lane):
    line = lane.centerline
    return line.length - line[0].distanceTo(line[-1]) < 0.2
straightLanes = [lane for lane in network.lanes if lane.centerline.length > 250 and isStraight(lane)]
egoLane = Uniform(*straightLanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(80), facing roadDirection
