# component: O
# description: An animal runs across the road from the right (a walker with the role name animal stands in).
# paraphrases:
#   - deer jumps onto the carriageway
#   - wildlife crosses in front of the car
#   - a wild animal leaps out of the woods
# positions: [roadside]
# actions: [cross_road]
# types: [animal]
# ---
animalPoint = new OrientedPoint following roadDirection from egoSpot for 40
animalStart = new OrientedPoint right of animalPoint by 5

behavior RunsOver(speed, near):
    while (distance from self to ego) > near:
        wait
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

deer = new Pedestrian at animalStart, facing 90 deg relative to animalPoint.heading,
    with rolename 'animal',
    with regionContainedIn None,
    with behavior RunsOver(4, 30)
