# component: O
# description: The lead car brakes moderately whenever its speed is above a limit that falls after four seconds.
# paraphrases:
#   - gentle slowing of the vehicle in front
#   - the car in front eases off
#   - the car in front slows down gently
# positions: [ahead]
# actions: [brake]
# types: [car]
# ---
behavior LeadGivesWay(fast, slow):
    try:
        do FollowLaneBehavior(target_speed=fast)
    interrupt when simulation().currentTime > 40 and self.speed > slow:
        take SetThrottleAction(0), SetBrakeAction(0.3)

lead = new Car ahead of ego by 14, with behavior LeadGivesWay(9, 4)
