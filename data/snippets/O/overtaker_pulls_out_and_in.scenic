# component: O
# description: A car behind ego pulls out to the left, overtakes and returns to ego's lane in front of it.
# paraphrases:
#   - complete passing manoeuvre from the rear
#   - follower gets past and slots back in
#   - the car behind pulls out, passes and returns in front of me
# positions: [behind]
# actions: [overtake, lane_change]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
passSection = network.laneSectionAt(egoSpot).laneToLeft

behavior OvertakesEgo(speed):
    do FollowLaneBehavior(target_speed=speed) until (distance from self to ego) < 14
    do LaneChangeBehavior(passSection, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed) until (distance past ego of self) > 12
    do LaneChangeBehavior(network.laneSectionAt(egoSpot), target_speed=speed)
    do FollowLaneBehavior(target_speed=speed)

chaserSpot = new OrientedPoint following roadDirection from egoSpot for -18
chaser = new Car at chaserSpot, facing roadDirection, with behavior OvertakesEgo(15)
