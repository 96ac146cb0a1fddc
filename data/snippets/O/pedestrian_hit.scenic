# component: O
# description: A pedestrian walks into the road so late that ego hits them unless it brakes.
# paraphrases:
#   - unavoidable pedestrian impact
#   - steps out right in front of the bumper
#   - somebody steps right in front of my bumper
# positions: [sidewalk]
# actions: [collide, cross_road]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
lateP = new OrientedPoint following roadDirection from egoSpot for 30
lateStart = new OrientedPoint right of lateP by 2.6

behavior StepsOutLate(gap):
    while (distance from self to ego) > gap:
        wait
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(2)

latePerson = new Pedestrian at lateStart, facing 90 deg relative to lateP.heading,
    with regionContainedIn None,
    with behavior StepsOutLate(12)
