# component: E
# description: Ego drives at the posted limit of 50 km/h, converted to metres per second.
# paraphrases:
#   - travel at the legal speed in town
#   - my car keeps to the speed limit
#   - drive as fast as the sign allows
# actions: [keep_lane]
# ---
KMH = 1 / 3.6
SPEED_LIMIT = 50 * KMH
ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.tesla.model3',
    with behavior FollowLaneBehavior(target_speed=SPEED_LIMIT)
