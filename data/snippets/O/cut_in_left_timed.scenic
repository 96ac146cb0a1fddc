# component: O
# description: A car in the left lane, ahead of ego, cuts in front of ego after two seconds.
# paraphrases:
#   - a vehicle from the neighbouring lane squeezes in ahead
#   - merging in close from the left
#   - another driver pushes into my lane from the side
#   - moves over into my path just in front of me
# positions: [left_lane]
# actions: [cut_in]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
leftSection = network.laneSectionAt(egoSpot).laneToLeft
cutInSpot = new OrientedPoint at leftSection.centerline.project(ego.position), facing roadDirection
startSpot = new OrientedPoint following roadDirection from cutInSpot for 12

behavior CutsIn(speed):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    do LaneChangeBehavior(network.laneSectionAt(egoSpot), target_speed=speed)
    do FollowLaneBehavior(target_speed=speed)

adversary = new Car at startSpot, facing roadDirection, with behavior CutsIn(8)
