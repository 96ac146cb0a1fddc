# component: O
# description: A truck drives in the left lane, 20 metres ahead of ego.
# paraphrases:
#   - lorry occupies the passing lane
#   - a truck in the lane to my left
#   - a slow truck drives to the left of me
# positions: [left_lane]
# actions: [keep_lane]
# types: [truck]
# hosts: [R/road_two_lanes_same_direction]
# ---
upSpot = new OrientedPoint following roadDirection from egoSpot for 20
truck = new Truck left of upSpot by 2.3, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=8)
