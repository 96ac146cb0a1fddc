# component: O
# description: A truck drives towards ego on the opposite lane group.
# paraphrases:
#   - heavy oncoming vehicle on the other side of the road
#   - a truck passes in the opposite direction
#   - a truck comes towards me on the other side of the road
# positions: [oncoming_lane]
# actions: [keep_lane]
# types: [truck]
# hosts: [R/road_opposite_group_exists]
# ---
oncomingTruck = new Truck on opposingLane.centerline, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=8)
require 40 < (distance from oncomingTruck to ego) < 160
