# component: E
# description: Ego turns right at the intersection and then keeps to its new lane.
# paraphrases:
#   - right turn into the side road
#   - nearside turning vehicle under test
#   - go right at the junction
# actions: [turn_right]
# hosts: [R/intersection_right_turn]
# ---
behavior EgoTurnsRight(path):
    do FollowTrajectoryBehavior(target_speed=6, trajectory=path)
    do FollowLaneBehavior(target_speed=8)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoTurnsRight(egoPath)
