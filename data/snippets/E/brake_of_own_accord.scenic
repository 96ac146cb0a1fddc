# component: E
# description: Ego slows from 12 to 5 m/s of its own accord, without a reason ahead.
# paraphrases:
#   - speed reduction of the host vehicle
#   - become slower for no reason
#   - my car slows down although the road is empty
# actions: [brake]
# ---
behavior EgoSlowsDown(high, low):
    do FollowLaneBehavior(target_speed=high) for 4 seconds
    do FollowLaneBehavior(target_speed=low) until self.speed < low
    do FollowLaneBehavior(target_speed=low)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoSlowsDown(12, 5)
