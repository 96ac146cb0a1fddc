# component: E
# description: Ego merges from the ramp onto the motorway at 14 m/s and then follows the lane there.
# paraphrases:
#   - join the highway from the acceleration lane
#   - on-ramp merging by trajectory
#   - drive up the slip road onto the highway
# actions: [keep_lane]
# hosts: [R/on_ramp_merge]
# ---
behavior EgoMerges(path, speed):
    do FollowTrajectoryBehavior(target_speed=speed, turn_speed=speed, trajectory=path)
    do FollowLaneBehavior(target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoMerges(egoPath, 14)
