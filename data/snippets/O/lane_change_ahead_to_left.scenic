# component: O
# description: A bus ahead in ego's lane changes to the left lane when ego is within 20 metres.
# paraphrases:
#   - coach moves out to the inner lane
#   - a bus in front moves over
# positions: [ahead]
# actions: [lane_change]
# types: [bus]
# hosts: [R/road_two_lanes_same_direction]
# ---
behavior BusChangesLane(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when (distance from self to ego) < 20:
        do LaneChangeBehavior(network.laneSectionAt(self).laneToLeft, target_speed=speed)
        abort
    do FollowLaneBehavior(target_speed=speed)

bus = new Bus ahead of ego by 18, with width 2.6, with behavior BusChangesLane(6)
