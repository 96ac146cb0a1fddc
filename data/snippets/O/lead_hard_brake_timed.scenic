# component: O
# description: The car ahead of ego brakes hard three seconds after the start.
# paraphrases:
#   - sudden deceleration of the leader
#   - the one in front slams on the brakes
#   - the vehicle in front does an emergency stop out of the blue
# positions: [ahead]
# actions: [brake]
# types: [car]
# ---
behavior LeadBrakesHard(speed, after):
    do FollowLaneBehavior(target_speed=speed) for after seconds
    while self.speed > 1:
        take SetThrottleAction(0), SetBrakeAction(1)
    do FollowLaneBehavior(target_speed=3)

lead = new Car ahead of ego by Range(10, 15),
    with behavior LeadBrakesHard(9, 3)
