# component: O
# description: A car comes towards ego in the oncoming lane and stays there.
# paraphrases:
#   - opposing traffic passes by
#   - vehicle from the other direction
#   - a car passes in the opposite direction
# positions: [oncoming_lane]
# actions: [keep_lane]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
meetSpot = new OrientedPoint following roadDirection from egoSpot for 60
oncomer = new Car at oncomingLane.centerline.project(meetSpot.position), facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=9)
