# component: O
# description: A motorcycle ahead opens the throttle fully once ego is within 20 metres.
# paraphrases:
#   - biker shoots off
#   - a motorbike in front shoots off
#   - a motorbike in front of me speeds up and gets away
# positions: [ahead]
# actions: [accelerate]
# types: [motorcycle]
# ---
behavior RiderOpensThrottle():
    do FollowLaneBehavior(target_speed=5) until (distance from self to ego) < 20
    take SetThrottleAction(1), SetBrakeAction(0)
    do FollowLaneBehavior(target_speed=14)

riderSpot = new OrientedPoint following roadDirection from egoSpot for 22
rider = new Motorcycle at riderSpot, facing roadDirection, with behavior RiderOpensThrottle()
