# component: O
# description: A car in the left lane steers into ego's side.
# paraphrases:
#   - sideswipe
#   - neighbour veers into the test vehicle
#   - a car next to me rams my side
# positions: [left_lane]
# actions: [collide]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
behavior SteersInto(speed):
    do FollowLaneBehavior(target_speed=speed) for 1 seconds
    while True:
        take SetThrottleAction(0.5), SetSteerAction(0.15)

sideSpot = new OrientedPoint following roadDirection from egoSpot for 4
sider = new Car left of sideSpot by 2.6, facing roadDirection, with behavior SteersInto(10)
