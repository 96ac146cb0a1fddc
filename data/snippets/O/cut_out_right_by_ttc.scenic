# component: O
# description: A van ahead of ego in the left lane moves to the right when ego is two seconds behind it.
# paraphrases:
#   - leader clears the passing lane
#   - the one in front moves over to the right and lets me by
#   - a van in front of me leaves my lane to the right
# positions: [ahead]
# actions: [cut_out]
# types: [van]
# hosts: [R/road_left_of_two_lanes]
# ---
clearSection = egoSection.laneToRight

behavior ClearsLane(speed, headway):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when (distance from self to ego) < headway * max(ego.speed, 2):
        do LaneChangeBehavior(clearSection, target_speed=speed)
        do FollowLaneBehavior(target_speed=speed)

van = new Van ahead of ego by 18, with behavior ClearsLane(6, 2)
