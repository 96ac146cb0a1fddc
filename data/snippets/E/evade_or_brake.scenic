# component: E
# description: Ego changes lanes for an obstacle if it sees it early, and brakes if it is already too near.
# paraphrases:
#   - prefer overtaking, fall back on stopping
#   - dodge something or else stop
#   - my car steers round something if there is time, otherwise it brakes
# reactions: [evade]
# hosts: [R/road_two_lanes_same_direction]
# ---
egoSection = network.laneSectionAt(egoSpot)

behavior EgoEvadesOrBrakes(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToObjsInLane(self, 25):
        do LaneChangeBehavior(egoSection.laneToLeft, target_speed=speed)
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToObjsInLane(self, 8):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoEvadesOrBrakes(8)
