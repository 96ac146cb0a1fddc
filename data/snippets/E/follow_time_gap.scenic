# component: E
# description: Ego keeps a time gap of two seconds to any vehicle in front by coasting and braking.
# paraphrases:
#   - two-second rule
#   - maintain headway in seconds
#   - keep two seconds behind the car in front
# reactions: [follow]
# ---
behavior EgoTimeGap(speed, headway):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyCars(self, max(8, headway * self.speed)) and withinDistanceToObjsInLane(self, headway * self.speed + 4):
        take SetThrottleAction(0), SetBrakeAction(0.4)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoTimeGap(11, 2)
