# component: O
# description: A fast car in the left lane comes from behind and goes past ego.
# paraphrases:
#   - being overtaken on the left
#   - vehicle rushes by in the next lane
#   - a speeding car passes me on the left
#   - somebody races past
# positions: [left_lane]
# actions: [overtake]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
rearSpot = new OrientedPoint following roadDirection from egoSpot for -20
overtaker = new Car left of rearSpot by 2.6, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=15)
