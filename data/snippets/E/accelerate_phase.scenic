# component: E
# description: Ego drives at 5 m/s, then speeds up to 12 m/s.
# paraphrases:
#   - increase the speed after a few seconds
#   - acceleration phase of the test vehicle
#   - go faster after some time
#   - get up to a higher speed later
# actions: [accelerate]
# ---
behavior EgoSpeedsUp(slow, fast, after):
    do FollowLaneBehavior(target_speed=slow) for after seconds
    do FollowLaneBehavior(target_speed=fast)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoSpeedsUp(5, 12, 3)
