# component: E
# description: Ego turns left and brakes for any object within 10 metres on the way.
# paraphrases:
#   - careful left turn
#   - turn across traffic, stop if somebody comes
#   - my car turns left and stops for anybody in its way
# actions: [turn_left]
# reactions: [brake]
# hosts: [R/intersection_left_turn]
# ---
behavior EgoTurnsLeftCarefully(path):
    try:
        do FollowTrajectoryBehavior(target_speed=6, trajectory=path)
    interrupt when withinDistanceToAnyObjs(self, 10):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoTurnsLeftCarefully(egoPath)
