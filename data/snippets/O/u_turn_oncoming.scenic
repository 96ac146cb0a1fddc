# component: O
# description: An oncoming car makes a U-turn in front of ego.
# paraphrases:
#   - opposing driver turns round across the host's lane
#   - a car from the other direction turns around right in front of me
#   - a car coming towards me turns round in front of me
# positions: [oncoming_lane]
# actions: [u_turn]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
turnRoundSpot = new OrientedPoint following roadDirection from egoSpot for 45

behavior TurnsRound(speed):
    do FollowLaneBehavior(target_speed=speed) for 1 seconds
    while (distance from self to turnRoundSpot) < 12:
        take SetThrottleAction(0.3), SetSteerAction(-1), SetBrakeAction(0)
    do FollowLaneBehavior(target_speed=speed, laneToFollow=egoLane)

turner = new Car at oncomingLane.centerline.project(turnRoundSpot.position), facing roadDirection,
    with behavior TurnsRound(3)
