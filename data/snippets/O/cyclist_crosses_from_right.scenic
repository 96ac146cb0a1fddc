# component: O
# description: A cyclist crosses the road from the right in front of ego.
# paraphrases:
#   - bike traverses the carriageway
#   - pedal cyclist rides across the host's path
#   - somebody on a bicycle crosses in front of me
# positions: [crossing_right]
# actions: [cross_road]
# types: [bicycle]
# hosts: [R/road_with_sidewalk]
# ---
bikeCross = new OrientedPoint following roadDirection from egoSpot for 35
bikeStart = new OrientedPoint right of bikeCross by 7

behavior RidesAcross(speed):
    while True:
        take SetThrottleAction(0.6 if self.speed < speed else 0), SetSteerAction(0)

crossingBike = new Bicycle at bikeStart, facing 90 deg relative to bikeCross.heading,
    with regionContainedIn None,
    with behavior RidesAcross(4)
