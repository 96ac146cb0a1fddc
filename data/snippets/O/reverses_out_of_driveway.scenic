# component: O
# description: A car backs out of a driveway at the right, across ego's path.
# paraphrases:
#   - reversing from a private entrance onto the street
#   - somebody backs out of a drive onto the road
#   - a car reverses onto the road in front of me
# positions: [roadside]
# actions: [reverse, enter_road]
# types: [car]
# hosts: [R/road_with_sidewalk]
# ---
drivewaySpot = new OrientedPoint following roadDirection from egoSpot for 30

behavior BacksOut():
    while (distance from self to ego) > 28:
        take SetBrakeAction(1)
    while True:
        take SetReverseAction(True), SetThrottleAction(0.35), SetBrakeAction(0)

backer = new Car right of drivewaySpot by 5, facing -90 deg relative to roadDirection,
    with regionContainedIn None,
    with behavior BacksOut()
