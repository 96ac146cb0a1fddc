# component: O
# description: An oncoming car slips towards the centre line and catches itself.
# paraphrases:
#   - opposing vehicle skids on a wet road
#   - a car from the other direction slides on a slippery road
#   - a car coming towards me loses control for a moment
# positions: [oncoming_lane]
# actions: [lose_control]
# types: [car]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
meetPoint = new OrientedPoint following roadDirection from egoSpot for 65

behavior SlipsAndRecovers(speed, near):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when near - 4 < (distance from self to ego) < near:
        take SetSteerAction(-0.2), SetBrakeAction(0.2)

slipper = new Car at oncomingLane.centerline.project(meetPoint.position), facing roadDirection,
    with behavior SlipsAndRecovers(8, 40)
