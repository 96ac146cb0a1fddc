# component: O
# description: A slower car drives in the right lane, ahead of ego.
# paraphrases:
#   - traffic in the slow lane that ego will pass
#   - a slow car in the lane to my right
# positions: [right_lane]
# actions: [keep_lane]
# types: [car]
# hosts: [R/road_left_of_two_lanes]
# ---
lowerSection = egoSection.laneToRight
passedSpot = new OrientedPoint following roadDirection from egoSpot for 18
passed = new Car at lowerSection.centerline.project(passedSpot.position), facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=6)
