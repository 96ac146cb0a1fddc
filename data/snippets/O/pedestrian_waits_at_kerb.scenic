# component: O
# description: A pedestrian waits at the kerb for five seconds and then crosses.
# paraphrases:
#   - person lets traffic pass before walking
#   - somebody waits at the edge of the street before walking over
#   - a person stands at the edge of the road and crosses a little later
# positions: [sidewalk]
# actions: [wait]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
kerbPoint = new OrientedPoint following roadDirection from egoSpot for 45
kerbStart = new OrientedPoint right of kerbPoint by 4

behavior WaitsThenCrosses(seconds, speed):
    do StandsStill() for seconds seconds
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

behavior StandsStill():
    while True:
        take SetWalkingSpeedAction(0)

kerbPerson = new Pedestrian at kerbStart, facing 90 deg relative to kerbPoint.heading,
    with regionContainedIn None,
    with behavior WaitsThenCrosses(5, 1.4)
