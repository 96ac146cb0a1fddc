# component: O
# description: A motorcycle filters between the lanes and passes ego closely on the left.
# paraphrases:
#   - lane-splitting biker
#   - a motorbike squeezes past between the cars
#   - a motorcycle passes between me and the next lane
# positions: [behind]
# actions: [overtake]
# types: [motorcycle]
# hosts: [R/road_two_lanes_same_direction]
# ---
filterSpot = new OrientedPoint following roadDirection from egoSpot for -12

behavior Filters(speed):
    while True:
        take SetThrottleAction(0.7 if self.speed < speed else 0), SetSteerAction(0)

splitter = new Motorcycle left of filterSpot by 1.5, facing roadDirection, with behavior Filters(14)
