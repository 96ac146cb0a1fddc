# component: E
# description: Ego turning left lets the opposing traffic pass before it crosses their lane.
# paraphrases:
#   - unprotected left turn, wait for a gap
#   - yield to oncoming cars when turning
#   - wait for a gap before going left
# actions: [turn_left]
# reactions: [yield]
# hosts: [R/intersection_left_turn_with_opposing]
# ---
behavior EgoWaitsForGap(path):
    try:
        do FollowTrajectoryBehavior(target_speed=6, trajectory=path)
    interrupt when (self in network.intersectionRegion) and withinDistanceToAnyCars(self, 18):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoWaitsForGap(egoPath)
