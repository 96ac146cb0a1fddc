# component: O
# description: The lead vehicle decelerates to a standstill and stays there.
# paraphrases:
#   - the car in front comes to a complete halt
#   - leader brakes until it no longer moves
#   - the car in front stops completely
# positions: [ahead]
# actions: [stop]
# types: [car]
# ---
behavior LeadStops(speed, after):
    do FollowLaneBehavior(target_speed=speed) for after seconds
    while True:
        take SetThrottleAction(0), SetBrakeAction(0.8)

lead = new Car ahead of ego by 16, with behavior LeadStops(8, Range(2, 4))
