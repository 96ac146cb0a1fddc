# component: O
# description: An oncoming car crosses the centre line and hits ego head-on.
# paraphrases:
#   - frontal crash with opposing traffic
#   - frontal collision with a car from the other direction
# positions: [oncoming_lane]
# actions: [collide, oncoming]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
aheadPoint = new OrientedPoint following roadDirection from egoSpot for 50

behavior RunsHeadOn():
    while True:
        heading_error = angle from self to ego
        take SetThrottleAction(0.5), SetSteerAction(max(-0.3, min(0.3, self.heading - heading_error)))

headOn = new Car at oncomingLane.centerline.project(aheadPoint.position), facing roadDirection,
    with behavior RunsHeadOn()
