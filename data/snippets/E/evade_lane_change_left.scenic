# component: E
# description: Ego evades an obstacle by changing to the lane on its left.
# paraphrases:
#   - steer round the blockage into the neighbouring lane
#   - avoid what is ahead by moving over
#   - go around something by moving over to the left
# actions: [lane_change]
# reactions: [evade]
# hosts: [R/road_two_lanes_same_direction]
# ---
evasionLane = Uniform(*filter(lambda s: s._laneToLeft is not None, egoLane.sections))

behavior EgoEvades(speed, section):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, 20):
        do LaneChangeBehavior(section, target_speed=speed)
        do FollowLaneBehavior(target_speed=speed, laneToFollow=section.lane)

ego = new Car at egoSpot, facing roadDirection,
    with behavior EgoEvades(9, evasionLane.laneToLeft)
