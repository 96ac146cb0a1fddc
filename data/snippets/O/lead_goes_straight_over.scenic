# component: O
# description: A bus ahead of ego goes straight over the intersection.
# paraphrases:
#   - leader crosses the junction first
#   - a bus in front of me drives straight over the junction
#   - the bus ahead crosses the intersection before me
# positions: [ahead]
# actions: [go_straight]
# types: [bus]
# hosts: [R/intersection_four_way]
# ---
busLead = new Bus ahead of ego by 8, with width 2.6,
    with behavior FollowTrajectoryBehavior(target_speed=7, turn_speed=7, trajectory=egoPath)
