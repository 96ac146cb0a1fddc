# component: E
# description: Ego brakes when the distance to anything ahead is less than its braking distance plus a margin.
# paraphrases:
#   - the faster it goes, the earlier it slows
#   - stopping distance computed from the speed
#   - my car brakes sooner the faster it drives
# reactions: [brake]
# ---
behavior EgoBrakesInTime(speed, deceleration):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, 6 + self.speed * self.speed / (2 * deceleration)):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoBrakesInTime(12, 5)
