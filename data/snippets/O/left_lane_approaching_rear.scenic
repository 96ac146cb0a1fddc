# component: O
# description: A car approaches fast in the left lane from 40 metres behind ego.
# paraphrases:
#   - rapidly closing traffic in the target lane of a lane change
#   - a much faster car comes up from behind in the next lane
# positions: [left_lane]
# actions: [keep_lane]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
targetLane = network.laneSectionAt(egoSpot).laneToLeft.lane
rearPoint = new OrientedPoint following roadDirection from egoSpot for -40
approaching = new Car at targetLane.centerline.project(rearPoint.position), facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=16)
