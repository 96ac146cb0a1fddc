# component: E
# description: Ego goes straight over the intersection at 9 m/s.
# paraphrases:
#   - cross the junction without turning
#   - continue ahead through the crossroads
#   - my car drives straight over the crossroads
# actions: [go_straight]
# hosts: [R/intersection_four_way]
# ---
ego = new Car at egoSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=9, turn_speed=9, trajectory=egoPath)
