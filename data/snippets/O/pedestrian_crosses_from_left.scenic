# component: O
# description: A pedestrian crosses from the left, over the oncoming lane, into ego's lane.
# paraphrases:
#   - walker comes from the far side of the road
#   - person crosses from the opposite kerb
#   - somebody on foot walks across from the other side
# positions: [oncoming_lane]
# actions: [cross_road]
# types: [pedestrian]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
farPoint = new OrientedPoint following roadDirection from egoSpot for 32
leftKerb = new OrientedPoint left of farPoint by 6

behavior CrossesFromLeft(speed):
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

farWalker = new Pedestrian at leftKerb, facing -90 deg relative to farPoint.heading,
    with regionContainedIn None,
    with behavior CrossesFromLeft(Range(1.2, 1.8))
