# component: E
# description: Ego brakes for objects in its own lane only, at a distance of 12 metres.
# paraphrases:
#   - ignore neighbours, stop for what blocks the lane
#   - AEB for the own lane
#   - my car brakes only for what is in its own lane
# reactions: [brake]
# ---
behavior EgoLaneBrake(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToObjsInLane(self, gap):
        take SetThrottleAction(0), SetBrakeAction(0.8)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoLaneBrake(9, 12)
