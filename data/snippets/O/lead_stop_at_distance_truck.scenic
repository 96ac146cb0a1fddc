# component: O
# description: A truck ahead stops dead as soon as ego is nearer than 20 metres.
# paraphrases:
#   - lorry halts in front of the host
#   - a heavy goods vehicle abruptly halts right in front of me
#   - a truck in front of me suddenly stops
# positions: [ahead]
# actions: [stop]
# types: [truck]
# ---
behavior TruckHalts(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when (distance from self to ego) < gap:
        take SetBrakeAction(1), SetThrottleAction(0)

truckSpot = new OrientedPoint following roadDirection from egoSpot for 28
truck = new Truck at truckSpot, facing roadDirection, with behavior TruckHalts(6, 20)
