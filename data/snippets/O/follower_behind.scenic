# component: O
# description: A car follows ego in the same lane and brakes when it comes too close.
# paraphrases:
#   - somebody keeps behind the test vehicle
#   - tail vehicle that adapts to ego
#   - a car behind me in my lane
#   - the vehicle to the rear keeps its distance
# positions: [behind]
# actions: [follow]
# types: [car]
# ---
behavior FollowsEgo(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when (distance from self to ego) < gap:
        take SetThrottleAction(0), SetBrakeAction(0.5)

tail = new Car behind ego by 12, with behavior FollowsEgo(11, 10)
