# component: O
# description: The car ahead pulls off the road to the right and stops on the shoulder.
# paraphrases:
#   - leader drives onto the verge
#   - vehicle in front parks at the side
#   - the car in front goes off the road and stops there
# positions: [ahead]
# actions: [leave_road]
# types: [car]
# hosts: [R/road_with_parking_lane]
# ---
behavior PullsOff(speed):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    for i in range(12):
        take SetSteerAction(0.1), SetThrottleAction(0.1)
    for i in range(9):
        take SetSteerAction(-0.1), SetThrottleAction(0)
    while True:
        take SetBrakeAction(0.8), SetSteerAction(0)

lead = new Car ahead of ego by 15, with behavior PullsOff(7)
