# component: O
# description: Two trucks follow each other in the right lane.
# paraphrases:
#   - convoy of lorries on the nearside
#   - a convoy of trucks in the right lane
#   - two lorries drive one behind the other to my right
# positions: [right_lane]
# actions: [keep_lane]
# types: [truck]
# hosts: [R/road_left_of_two_lanes]
# ---
platoonSpot = new OrientedPoint following roadDirection from egoSpot for 10
rearTruck = new Truck right of platoonSpot by 2.3, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=8)
frontTruck = new Truck ahead of rearTruck by 12,
    with behavior FollowLaneBehavior(target_speed=8)
