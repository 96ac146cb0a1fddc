# component: O
# description: The car ahead slows to half its speed when ego has come closer than 18 metres.
# paraphrases:
#   - leader reduces its speed as the follower approaches
#   - deceleration triggered by the gap
#   - the car in front gets slower as I come nearer
# positions: [ahead]
# actions: [brake]
# types: [car]
# ---
behavior LeadSlowsWhenClose(speed, gap):
    do FollowLaneBehavior(target_speed=speed) until (distance from self to ego) < gap
    do FollowLaneBehavior(target_speed=speed / 2)

brakeSpot = new OrientedPoint following roadDirection from egoSpot for 24
lead = new Car at brakeSpot, facing roadDirection, with behavior LeadSlowsWhenClose(8, 18)
