# component: O
# description: A car in the right lane ahead changes into ego's lane when ego is within 15 metres.
# paraphrases:
#   - slow-lane vehicle pushes into the passing lane
#   - cut-in from the right-hand side
#   - another driver pushes into my lane from the right
# positions: [right_lane]
# actions: [cut_in]
# types: [car]
# hosts: [R/road_left_of_two_lanes]
# ---
slowSection = egoSection.laneToRight
aheadSpot = new OrientedPoint following roadDirection from egoSpot for 25
besideSpot = new OrientedPoint at slowSection.centerline.project(aheadSpot.position), facing roadDirection

behavior PushesIn(speed, gap):
    do FollowLaneBehavior(target_speed=speed) until (distance from self to ego) < gap
    do LaneChangeBehavior(egoSection, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed, laneToFollow=egoLane)

pusher = new Car at besideSpot, facing roadDirection, with behavior PushesIn(7, 15)
