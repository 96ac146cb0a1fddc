# component: O
# description: The car ahead of ego turns right at the intersection.
# paraphrases:
#   - leader leaves into the side road
#   - vehicle in front slows for a right turn
#   - the car in front turns right
# positions: [ahead]
# actions: [turn_right]
# types: [car]
# hosts: [R/intersection_right_turn]
# ---
turningLead = new Car ahead of ego by 8, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=6, trajectory=egoPath)
