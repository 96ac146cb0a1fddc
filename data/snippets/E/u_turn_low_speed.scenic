# component: E
# description: 'Ego turns round on the road: full left lock at low speed until it faces the other way, then it follows that lane.'
# paraphrases:
#   - U-turn on a two-way road
#   - reverse its direction of travel
#   - turn around
# actions: [u_turn]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
behavior EgoTurnsRound():
    do FollowLaneBehavior(target_speed=4) for 2 seconds
    while abs(relative heading of self from egoSpot) < 150 deg:
        take SetThrottleAction(0.3), SetBrakeAction(0), SetSteerAction(-1)
    do FollowLaneBehavior(target_speed=5, laneToFollow=oncomingLane)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoTurnsRound()
