# component: E
# description: Ego turns left at the intersection along the lanes of its manoeuvre.
# paraphrases:
#   - left at the junction by following a path of lanes
#   - make the left-hand turn
#   - go left at the junction
# actions: [turn_left]
# hosts: [R/intersection_left_turn]
# ---
ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior FollowTrajectoryBehavior(target_speed=7, trajectory=egoPath)
