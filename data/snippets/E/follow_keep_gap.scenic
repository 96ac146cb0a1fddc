# component: E
# description: 'Ego follows whoever is ahead in its lane: it adapts its speed to keep a gap of about 12 metres.'
# paraphrases:
#   - adaptive cruise control
#   - car-following with headway regulation
#   - keep a distance to the car in front
# reactions: [follow]
# ---
behavior EgoKeepsGap(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToObjsInLane(self, 2 * gap):
        do FollowLaneBehavior(target_speed=speed / 2) until not withinDistanceToObjsInLane(self, 2 * gap)
    interrupt when withinDistanceToObjsInLane(self, gap):
        take SetThrottleAction(0), SetBrakeAction(0.6)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoKeepsGap(12, 12)
