# component: O
# description: The lead car swerves round a box that lies in the lane, then returns to its lane.
# paraphrases:
#   - driver in front dodges lost cargo
#   - the car in front dodges an object on the road
# positions: [ahead]
# actions: [swerve]
# types: [car]
# ---
lostSpot = new OrientedPoint following roadDirection from egoSpot for 50
lostBox = new Box at lostSpot

behavior DodgesBox(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when (distance from self to lostBox) < 12 and (distance past lostBox of self) < 0:
        take SetSteerAction(-0.12), SetThrottleAction(0.2)

lead = new Car ahead of ego by 14, with behavior DodgesBox(8)
