# component: E
# description: Ego swerves within the road by a short steering pulse when something is close, then follows its lane again.
# paraphrases:
#   - jerk the wheel to miss an object
#   - evasive steering without a lane change
#   - dodge something by turning the wheel sharply
# reactions: [evade]
# ---
behavior EgoSwerves(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, 12):
        for i in range(6):
            take SetSteerAction(-0.25), SetThrottleAction(0.2)
        for i in range(6):
            take SetSteerAction(0.25), SetThrottleAction(0.2)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoSwerves(9)
