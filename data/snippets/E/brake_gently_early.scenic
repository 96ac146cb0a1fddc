# component: E
# description: 'Ego slows in two steps: gently at 25 metres, firmly at 12 metres from what is ahead.'
# paraphrases:
#   - anticipatory, comfortable deceleration
#   - graded braking
#   - slow down early and softly
# reactions: [brake]
# ---
behavior EgoBrakesInSteps(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, 25):
        take SetThrottleAction(0), SetBrakeAction(0.25)
    interrupt when withinDistanceToAnyObjs(self, 12):
        take SetThrottleAction(0), SetBrakeAction(0.9)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoBrakesInSteps(10)
