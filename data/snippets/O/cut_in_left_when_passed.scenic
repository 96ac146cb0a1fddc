# component: O
# description: A faster car comes from behind in the left lane, passes ego and cuts in once it is 10 metres ahead.
# paraphrases:
#   - overtaker pulls in right before the host
#   - passes and swings back into the lane too early
#   - passes me and pulls in sharply in front of me
# positions: [left_lane]
# actions: [overtake, cut_in]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
overtakeSection = network.laneSectionAt(egoSpot).laneToLeft
behindSpot = new OrientedPoint following roadDirection from egoSpot for -15

behavior PassesAndCutsIn(speed, lead):
    do FollowLaneBehavior(target_speed=speed) until (distance past ego of self) > lead
    do LaneChangeBehavior(network.laneSectionAt(egoSpot), target_speed=speed)
    do FollowLaneBehavior(target_speed=speed - 2)

overtaker = new Car left of behindSpot by 2.6, facing roadDirection,
    with behavior PassesAndCutsIn(14, 10)
