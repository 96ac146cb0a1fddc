# component: O
# description: A car well ahead in the left lane changes to the right lane and stays there.
# paraphrases:
#   - a neighbour moves over one lane far in front
#   - a car far in front moves one lane over
#   - a car in the left lane moves to the right, far ahead of me
# positions: [left_lane]
# actions: [lane_change]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
homeSection = network.laneSectionAt(egoSpot)
farSpot = new OrientedPoint following roadDirection from egoSpot for 40

behavior ChangesOneLane(speed, section):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    do LaneChangeBehavior(section, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed, laneToFollow=section.lane)

neighbour = new Car left of farSpot by 2.6, facing roadDirection,
    with behavior ChangesOneLane(8, homeSection)
