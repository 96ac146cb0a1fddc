# component: O
# description: A bus waits at its stop for three seconds and then moves into ego's lane.
# paraphrases:
#   - public transport vehicle pulls away from the stop
#   - a bus sets off after passengers have boarded
# positions: [parked]
# actions: [wait, enter_road]
# types: [bus]
# hosts: [R/road_with_parking_lane]
# ---
stopSpot = new OrientedPoint following roadDirection from egoSpot for 35

behavior BusLeavesStop(pause):
    do BusWaits() for pause seconds
    do FollowLaneBehavior(target_speed=6, laneToFollow=egoLane)

behavior BusWaits():
    while True:
        take SetBrakeAction(1), SetThrottleAction(0)

bus = new Bus right of stopSpot by 1.7, facing roadDirection,
    with width 2.6, with regionContainedIn None,
    with behavior BusLeavesStop(3)
