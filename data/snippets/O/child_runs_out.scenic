# component: O
# description: A child runs onto the road from between parked cars.
# paraphrases:
#   - kid darts out after a ball
#   - small pedestrian suddenly appears at speed
#   - a schoolchild dashes into the traffic between cars
#   - a kid chases a ball
# positions: [roadside]
# actions: [enter_road, cross_road]
# types: [child]
# hosts: [R/road_with_parking_lane]
# ---
dartPoint = new OrientedPoint following roadDirection from egoSpot for 36
coverA = new Car right of dartPoint by 2.2, facing roadDirection, with regionContainedIn None
gapSpot = new OrientedPoint ahead of coverA by 1

behavior DartsOut(speed):
    try:
        while True:
            take SetWalkingSpeedAction(0)
    interrupt when (distance from self to ego) < 24:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

child = new Pedestrian at gapSpot, facing 90 deg relative to dartPoint.heading,
    with blueprint Uniform('walker.pedestrian.0009', 'walker.pedestrian.0011'),
    with regionContainedIn None,
    with behavior DartsOut(3)
