# component: E
# description: Ego brakes as late as possible, with full force, seven metres before an obstacle.
# paraphrases:
#   - last-moment emergency braking
#   - panic stop
#   - slam on the brakes at the last moment
# reactions: [brake]
# ---
behavior EgoBrakesLate(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, 7):
        while self.speed > 0.1:
            take SetThrottleAction(0), SetBrakeAction(1), SetHandBrakeAction(True)
        take SetHandBrakeAction(False)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoBrakesLate(8)
