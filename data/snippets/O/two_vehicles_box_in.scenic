# component: O
# description: One car drives ahead of ego and another beside it, so that ego is boxed in.
# paraphrases:
#   - surrounded on two sides
#   - hemmed in by cars in front and at the side
# positions: [ahead, beside]
# actions: [keep_lane]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
boxFront = new Car ahead of ego by 12, with behavior FollowLaneBehavior(target_speed=7)
boxSide = new Car left of ego by 1.6, facing roadDirection, with behavior FollowLaneBehavior(target_speed=10)
