# component: O
# description: Three pedestrians cross the road one beside the other.
# paraphrases:
#   - a group of people traverses the street
#   - several walkers at once
#   - a bunch of people walks across
# positions: [sidewalk]
# actions: [cross_road]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
groupPoint = new OrientedPoint following roadDirection from egoSpot for 38
groupStart = new OrientedPoint right of groupPoint by 4.5

behavior CrossesInGroup(speed):
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

personA = new Pedestrian at groupStart, facing 90 deg relative to groupPoint.heading,
    with regionContainedIn None, with behavior CrossesInGroup(1.2)
personB = new Pedestrian left of personA by 0.6,
    with regionContainedIn None, with behavior CrossesInGroup(1.25)
personC = new Pedestrian right of personA by 0.6,
    with regionContainedIn None, with behavior CrossesInGroup(1.3)
