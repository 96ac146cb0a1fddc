# component: E
# description: Ego brakes to a stand for an obstacle and goes on once the way is free again.
# paraphrases:
#   - wait until the road clears, then resume
#   - stop and continue afterwards
#   - my car stops for something on the road and drives on when it is gone
# reactions: [brake]
# ---
behavior EgoStopsAndResumes(speed, gap):
    while True:
        do FollowLaneBehavior(target_speed=speed) until withinDistanceToAnyObjs(self, gap)
        while withinDistanceToAnyObjs(self, gap + 3):
            take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoStopsAndResumes(8, 12)
