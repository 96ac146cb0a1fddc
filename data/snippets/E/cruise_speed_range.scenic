# component: E
# description: Ego follows its lane at a speed drawn between 8 and 14 m/s.
# paraphrases:
#   - varying cruising speed from run to run
#   - my car drives along at some ordinary speed
# actions: [keep_lane]
# ---
EGO_SPEED = Range(8, 14)
ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior FollowLaneBehavior(target_speed=EGO_SPEED)
