# component: O
# description: A pedestrian hidden behind a parked van steps into the road in front of ego.
# paraphrases:
#   - obstructed view, somebody appears between standing vehicles
#   - person emerges from behind a delivery van
#   - somebody on foot appears whom I could not see behind a parked vehicle
# positions: [roadside]
# actions: [cross_road, enter_road]
# types: [pedestrian, van]
# hosts: [R/road_with_parking_lane]
# ---
vanPoint = new OrientedPoint following roadDirection from egoSpot for 32
coverVan = new Van right of vanPoint by 2, facing roadDirection, with regionContainedIn None
hiddenStart = new OrientedPoint ahead of coverVan by 1.2

behavior EmergesFromCover(near, speed):
    while (distance from self to ego) > near:
        wait
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

hiddenWalker = new Pedestrian at hiddenStart, facing 90 deg relative to vanPoint.heading,
    with regionContainedIn None,
    with behavior EmergesFromCover(28, 1.6)
