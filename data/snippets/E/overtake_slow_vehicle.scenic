# component: E
# description: 'Ego overtakes a slower vehicle: it pulls out when close, passes and pulls in again.'
# paraphrases:
#   - pass the car in front by the left lane
#   - get ahead of a slow leader and return
#   - get past a slow car
# actions: [overtake]
# hosts: [R/road_two_lanes_same_direction]
# ---
homeSection = network.laneSectionAt(egoSpot)

behavior EgoOvertakes(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToObjsInLane(self, 20):
        do LaneChangeBehavior(homeSection.laneToLeft, target_speed=speed)
        do FollowLaneBehavior(target_speed=speed) for 4 seconds
        do LaneChangeBehavior(homeSection, target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoOvertakes(10)
