# component: E
# description: Ego accelerates with full throttle until it has reached its speed, then holds the lane.
# paraphrases:
#   - flat out up to the target velocity
#   - my car pulls away hard and gets up to speed
#   - foot to the floor until it is fast enough
# actions: [accelerate]
# ---
behavior EgoFullThrottle(speed):
    while self.speed < speed:
        take SetThrottleAction(1), SetBrakeAction(0), SetSteerAction(0)
    do FollowLaneBehavior(target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoFullThrottle(10)
