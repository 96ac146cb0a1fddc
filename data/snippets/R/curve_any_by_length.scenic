# component: R
# description: A curved lane, chosen because its chord is clearly shorter than its centre line; ego starts near its beginning.
# paraphrases:
#   - winding road, whichever way it bends
#   - a lane that is not straight
#   - a bendy road
# places: [curve]
# ---
def sinuous(lane):
    return lane.centerline.length > 1.02 * lane.centerline[0].distanceTo(lane.centerline[-1])
curved = [lane for lane in network.lanes if lane.centerline.length > 250 and sinuous(lane)]
egoLane = Uniform(*curved)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(50), facing roadDirection
