# component: O
# description: A motorcycle moves over from the left lane of the motorway into ego's lane, close ahead.
# paraphrases:
#   - powered two-wheeler filters in before the car
#   - a motorbike pushes in just in front of me
# positions: [left_lane]
# actions: [cut_in]
# types: [motorcycle]
# hosts: [R/motorway_middle_lane]
# ---
bikeSection = network.laneSectionAt(egoSpot).laneToLeft
bikeSpot = new OrientedPoint at bikeSection.centerline.project((new OrientedPoint following roadDirection from egoSpot for 14).position), facing roadDirection

behavior RiderCutsIn(speed):
    do FollowLaneBehavior(target_speed=speed) for Range(1, 3) seconds
    do LaneChangeBehavior(network.laneSectionAt(egoSpot), target_speed=speed)
    do FollowLaneBehavior(target_speed=speed)

rider = new Motorcycle at bikeSpot, facing roadDirection, with behavior RiderCutsIn(9)
