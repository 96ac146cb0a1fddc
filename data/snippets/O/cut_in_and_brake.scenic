# component: O
# description: A car cuts in from the left and brakes as soon as it is in ego's lane.
# paraphrases:
#   - swoops in and slows down at once
#   - cut-in followed by deceleration
#   - pushes in front of me and brakes at once
#   - brake-checking after a lane change
# positions: [left_lane]
# actions: [cut_in, brake]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
cutSection = network.laneSectionAt(egoSpot)
nextSpot = new OrientedPoint following roadDirection from egoSpot for 10

behavior CutsInAndBrakes(speed):
    do FollowLaneBehavior(target_speed=speed) for 1.5 seconds
    do LaneChangeBehavior(cutSection, target_speed=speed)
    while self.speed > 3:
        take SetThrottleAction(0), SetBrakeAction(0.7)
    do FollowLaneBehavior(target_speed=3)

adversary = new Car left of nextSpot by 2.6, facing roadDirection,
    with behavior CutsInAndBrakes(9)
