# component: O
# description: A child at the roadside runs across as soon as ego is two seconds away.
# paraphrases:
#   - youngster rushes over the street
#   - a schoolchild dashes across the street
#   - a kid chases a ball onto the road
# positions: [roadside]
# actions: [cross_road]
# types: [child]
# hosts: [R/road_with_sidewalk]
# ---
childPoint = new OrientedPoint following roadDirection from egoSpot for 40
childStart = new OrientedPoint right of childPoint by 4.5

behavior RunsByTime(seconds, speed):
    while (distance from self to ego) > seconds * max(ego.speed, 1):
        wait
    while True:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

runner = new Pedestrian at childStart, facing 90 deg relative to childPoint.heading,
    with blueprint 'walker.pedestrian.0012',
    with regionContainedIn None,
    with behavior RunsByTime(2, 2.8)
