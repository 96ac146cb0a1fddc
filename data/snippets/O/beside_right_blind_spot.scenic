# component: O
# description: A motorcycle rides in ego's blind spot on the right.
# paraphrases:
#   - two-wheeler next to the car, hard to see
#   - somebody rides where I cannot see them in the mirror
# positions: [beside]
# actions: [keep_lane]
# types: [motorcycle]
# hosts: [R/road_left_of_two_lanes]
# ---
spotBehind = new OrientedPoint following roadDirection from egoSpot for -3
blind = new Motorcycle right of spotBehind by 3, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=10)
