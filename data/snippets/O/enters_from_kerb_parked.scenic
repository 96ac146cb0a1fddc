# component: O
# description: A parked car pulls out from the right kerb in front of ego.
# paraphrases:
#   - vehicle leaves its parking space without looking
#   - car at the roadside moves into the lane
#   - somebody drives out of a parking space right in front of me
# positions: [parked]
# actions: [enter_road]
# types: [car]
# hosts: [R/road_with_parking_lane]
# ---
parkedSpot = new OrientedPoint following roadDirection from egoSpot for 28

behavior PullsOut(speed, gap):
    while (distance from self to ego) > gap:
        take SetBrakeAction(1)
    do FollowLaneBehavior(target_speed=speed, laneToFollow=egoLane)

puller = new Car right of parkedSpot by 2, facing roadDirection,
    with regionContainedIn None,
    with behavior PullsOut(5, 22)
