# component: O
# description: A pedestrian steps onto the road, turns round and goes back.
# paraphrases:
#   - walker changes their mind half way
#   - somebody on foot turns back half way
#   - a person starts to cross the street, then goes back
# positions: [sidewalk]
# actions: [cross_road]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
backPoint = new OrientedPoint following roadDirection from egoSpot for 34
backStart = new OrientedPoint right of backPoint by 4

behavior TurnsBack(speed, seconds):
    do Strolls(self.heading, speed) for seconds seconds
    do Strolls(self.heading + 180 deg, speed)

behavior Strolls(heading, speed):
    while True:
        take SetWalkingDirectionAction(heading), SetWalkingSpeedAction(speed)

undecided = new Pedestrian at backStart, facing 90 deg relative to backPoint.heading,
    with regionContainedIn None,
    with behavior TurnsBack(1.3, 3)
