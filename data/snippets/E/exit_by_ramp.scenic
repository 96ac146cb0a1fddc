# component: E
# description: Ego leaves the motorway by the off-ramp, slowing from 16 m/s.
# paraphrases:
#   - take the exit and reduce speed
#   - leave the highway
#   - my car comes off the highway and slows down
# actions: [keep_lane]
# hosts: [R/off_ramp_exit]
# ---
behavior EgoExits(path):
    do FollowTrajectoryBehavior(target_speed=16, turn_speed=14, trajectory=path)
    do FollowLaneBehavior(target_speed=10)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoExits(egoPath)
