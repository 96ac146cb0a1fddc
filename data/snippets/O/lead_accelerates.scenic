# component: O
# description: The car ahead speeds up from 4 to 12 m/s after two seconds and draws away.
# paraphrases:
#   - leader pulls away
#   - vehicle in front gathers speed
#   - the car in front goes faster and gets away
#   - acceleration of the vehicle in front
# positions: [ahead]
# actions: [accelerate]
# types: [car]
# ---
behavior LeadDrawsAway(slow, fast):
    do FollowLaneBehavior(target_speed=slow) for 2 seconds
    do FollowLaneBehavior(target_speed=fast)

lead = new Car ahead of ego by 12, with behavior LeadDrawsAway(4, 12)
