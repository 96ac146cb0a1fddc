# component: O
# description: A car standing at the right edge ahead turns round across both lanes as ego comes near.
# paraphrases:
#   - makes an about-turn from the side of the road
#   - a car at the side turns around across the road
# positions: [parked]
# actions: [u_turn, enter_road]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
kerbTurn = new OrientedPoint following roadDirection from egoSpot for 30

behavior TurnsFromKerb(gap):
    while (distance from self to ego) > gap:
        take SetBrakeAction(1)
    while abs(relative heading of self from kerbTurn) < 160 deg:
        take SetBrakeAction(0), SetThrottleAction(0.3), SetSteerAction(-1)
    do FollowLaneBehavior(target_speed=5)

aboutTurn = new Car right of kerbTurn by 0.8, facing roadDirection,
    with regionContainedIn None,
    with behavior TurnsFromKerb(24)
