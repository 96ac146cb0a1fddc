# component: E
# description: Ego is a car that follows its lane at a constant speed and does not react to anybody.
# paraphrases:
#   - the vehicle under test just drives on at a steady pace
#   - constant velocity in its own lane, no reaction
#   - my car just drives along and ignores everybody
# actions: [keep_lane]
# types: [car]
# ---
ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior FollowLaneBehavior(target_speed=10)
