# component: O
# description: A car drives abreast of ego in the lane to the left at the same speed.
# paraphrases:
#   - vehicle alongside blocks the neighbouring lane
#   - companion side by side
#   - a car drives right next to me
# positions: [beside]
# actions: [keep_lane]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
companion = new Car left of ego by 1.6, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=10)
