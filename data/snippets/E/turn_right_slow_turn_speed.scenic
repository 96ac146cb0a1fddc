# component: E
# description: Ego approaches at 9 m/s and takes the right turn at 4 m/s.
# paraphrases:
#   - slow down for the corner
#   - separate approach and turning speeds
#   - my car slows down and turns right round the corner
# actions: [turn_right]
# hosts: [R/intersection_right_turn]
# ---
ego = new Car at egoSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=9, turn_speed=4, trajectory=egoPath)
