# component: O
# description: A cyclist waits at the roadside and crosses when ego is within 25 metres.
# paraphrases:
#   - bike sets off across the street at the wrong moment
#   - somebody on a bicycle rides out in front of me
# positions: [roadside]
# actions: [wait, cross_road]
# types: [bicycle]
# hosts: [R/road_with_sidewalk]
# ---
triggerPoint = new OrientedPoint following roadDirection from egoSpot for 40

behavior RidesWhenNear(near, throttle):
    try:
        while True:
            take SetBrakeAction(1), SetThrottleAction(0)
    interrupt when (distance from self to ego) < near:
        take SetBrakeAction(0), SetThrottleAction(throttle)

waitingBike = new Bicycle right of triggerPoint by 5, facing 90 deg relative to triggerPoint.heading,
    with regionContainedIn None,
    with behavior RidesWhenNear(25, 0.7)
