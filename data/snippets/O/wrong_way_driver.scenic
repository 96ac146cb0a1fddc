# component: O
# description: A wrong-way driver comes towards ego in ego's own lane.
# paraphrases:
#   - ghost driver
#   - vehicle travelling against the direction of traffic
#   - a car comes towards me on the wrong side of the road
# positions: [ahead]
# actions: [oncoming]
# types: [car]
# ---
behavior DrivesAgainst(speed):
    while True:
        take SetThrottleAction(0.4 if self.speed < speed else 0), SetSteerAction(0)

ghostSpot = new OrientedPoint following roadDirection from egoSpot for 70
ghost = new Car at ghostSpot, facing 180 deg relative to egoSpot.heading,
    with behavior DrivesAgainst(6)
