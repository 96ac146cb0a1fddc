# component: O
# description: A car of the other direction drifts over the centre line into ego's lane, head-on.
# paraphrases:
#   - wrong-side driver approaches in the host's lane
#   - opposing vehicle encroaches
#   - somebody comes at me on my side of the road
#   - a driver from the other direction in my lane
# positions: [oncoming_lane]
# actions: [oncoming]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
farAhead = new OrientedPoint following roadDirection from egoSpot for 70

behavior EncroachesOnEgo(speed):
    do FollowLaneBehavior(target_speed=speed) until (distance from self to ego) < 50
    do LaneChangeBehavior(egoSection, is_oppositeTraffic=True, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed, is_oppositeTraffic=True)

intruder = new Car at oncomingLane.centerline.project(farAhead.position), facing roadDirection,
    with behavior EncroachesOnEgo(7)
