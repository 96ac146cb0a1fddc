# component: O
# description: A pedestrian crosses the road that ego turns into, right behind the intersection.
# paraphrases:
#   - person on the crosswalk of the side street
#   - turning vehicle meets a walker
#   - somebody walks across the road I turn into
# positions: [intersection_exit]
# actions: [cross_road]
# types: [pedestrian]
# hosts: [R/intersection_right_turn]
# ---
exitPoint = new OrientedPoint following roadDirection from egoManeuver.endLane.centerline[0] for 6
walkStart = new OrientedPoint right of exitPoint by 4

behavior WalksAcross(speed):
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

exitWalker = new Pedestrian at walkStart, facing 90 deg relative to exitPoint.heading,
    with regionContainedIn None,
    with behavior WalksAcross(1.3)
