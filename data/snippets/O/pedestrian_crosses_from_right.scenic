# component: O
# description: A pedestrian crosses the road from the right-hand side in front of ego.
# paraphrases:
#   - walker steps onto the street from the near pavement
#   - person on foot traverses the host's lane
#   - somebody on foot walks across the street in front of me
# positions: [sidewalk]
# actions: [cross_road]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
crossPoint = new OrientedPoint following roadDirection from egoSpot for 35
rightKerb = new OrientedPoint right of crossPoint by 5

behavior CrossesStreet(speed, near):
    while (distance from self to ego) > near:
        wait
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

walker = new Pedestrian at rightKerb, facing 90 deg relative to crossPoint.heading,
    with regionContainedIn None,
    with behavior CrossesStreet(1.4, 25)
