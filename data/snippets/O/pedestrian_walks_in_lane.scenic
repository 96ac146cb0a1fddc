# component: O
# description: A pedestrian walks along the lane ahead of ego with their back to it.
# paraphrases:
#   - person on foot on a road without pavement
#   - walker in the carriageway, same direction
#   - somebody jogs or walks on the road in front of me, seen from behind
# positions: [ahead]
# actions: [move_along]
# types: [pedestrian]
# ---
laneWalkSpot = new OrientedPoint following roadDirection from egoSpot for 30

behavior WalksInLane(speed):
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

laneWalker = new Pedestrian at laneWalkSpot offset by (1, 0), facing egoSpot.heading,
    with regionContainedIn None,
    with behavior WalksInLane(1.2)
