# component: O
# description: Two cars drive ahead of ego; the rear one follows the front one at its pace.
# paraphrases:
#   - a platoon in front, the second adapts to the first
#   - two cars in front, one behind the other
#   - a car follows another one in front of me
# positions: [ahead]
# actions: [follow]
# types: [car]
# ---
behavior FollowsLeader(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when (distance from self to frontCar) < gap:
        take SetThrottleAction(0), SetBrakeAction(0.4)

frontSpot = new OrientedPoint following roadDirection from egoSpot for 40
frontCar = new Car at frontSpot, facing roadDirection, with behavior FollowLaneBehavior(target_speed=6)
secondCar = new Car behind frontCar by 9, with behavior FollowsLeader(9, 12)
