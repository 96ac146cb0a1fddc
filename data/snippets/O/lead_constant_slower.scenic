# component: O
# description: A slower car drives ahead of ego in the same lane at constant speed.
# paraphrases:
#   - the vehicle in front is slow
#   - catch up with a leader that holds its pace
#   - stuck behind a slowpoke
#   - a vehicle in front crawls along
# positions: [ahead]
# actions: [keep_lane]
# types: [car]
# ---
leadSpot = new OrientedPoint following roadDirection from egoSpot for Range(20, 30)
lead = new Car at leadSpot, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=6)
