# component: E
# description: Ego pulls away from the kerb into the driving lane.
# paraphrases:
#   - leave a parking bay and join the traffic
#   - parking exit of the test vehicle
#   - drive out of a parking space
# actions: [enter_road]
# hosts: [R/road_with_parking_lane]
# ---
kerbSpot = new OrientedPoint right of egoSpot by 3

behavior EgoPullsOut(speed):
    do FollowLaneBehavior(target_speed=speed, laneToFollow=egoLane)

ego = new Car at kerbSpot, facing roadDirection,
    with regionContainedIn None,
    with behavior EgoPullsOut(5)
