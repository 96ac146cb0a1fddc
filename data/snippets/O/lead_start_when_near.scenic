# component: O
# description: A bus waits in the lane and starts only when ego is less than 15 metres behind it.
# paraphrases:
#   - coach at a halt pulls off as the follower arrives
#   - a bus in the lane gets moving again when I arrive
#   - a standing bus drives off when I get near
# positions: [ahead]
# actions: [wait, start]
# types: [bus]
# ---
behavior BusStartsWhenNear(speed):
    while (distance from self to ego) > 15:
        take SetBrakeAction(1), SetThrottleAction(0)
    do FollowLaneBehavior(target_speed=speed)

busSpot = new OrientedPoint following roadDirection from egoSpot for 32
bus = new Bus at busSpot, facing roadDirection, with width 2.6, with behavior BusStartsWhenNear(6)
