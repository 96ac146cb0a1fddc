# component: O
# description: The lead car leaves ego's lane to the left after two seconds (cut-out).
# paraphrases:
#   - vehicle in front moves out of the way into the neighbouring lane
#   - leader changes lanes away from ego
#   - the car in front gets out of my lane
# positions: [ahead]
# actions: [cut_out]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
leaveSection = network.laneSectionAt(egoSpot).laneToLeft

behavior CutsOut(section, speed):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    do LaneChangeBehavior(section, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed, laneToFollow=section.lane)

lead = new Car ahead of ego by 14, with behavior CutsOut(leaveSection, 8)
