# component: O
# description: A pedestrian starts to cross, then stops in the middle of ego's lane.
# paraphrases:
#   - person freezes on the roadway
#   - hesitant walker halts in front of the car
#   - somebody on foot stops half way across the road
# positions: [sidewalk]
# actions: [cross_road, stop]
# types: [pedestrian]
# hosts: [R/road_with_sidewalk]
# ---
hesitatePoint = new OrientedPoint following roadDirection from egoSpot for 38
hesitateStart = new OrientedPoint right of hesitatePoint by 4.5

behavior HesitatesMidway(speed):
    while (distance from self to hesitatePoint) > 0.5:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)
    while True:
        take SetWalkingSpeedAction(0)

hesitant = new Pedestrian at hesitateStart, facing 90 deg relative to hesitatePoint.heading,
    with regionContainedIn None,
    with behavior HesitatesMidway(1.5)
