# component: O
# description: A cyclist rides along the right edge of the lane.
# paraphrases:
#   - bike keeps to the kerb side
#   - somebody on a bicycle at the side of my lane
# positions: [partly_in_lane]
# actions: [move_along]
# types: [bicycle]
# ---
behavior RidesStraight(speed):
    while True:
        take SetThrottleAction(0.5 if self.speed < speed else 0), SetSteerAction(0)

edge = new OrientedPoint following roadDirection from egoSpot for 20
edgeRider = new Bicycle at edge offset by (1.2, 0), facing roadDirection, with behavior RidesStraight(4)
