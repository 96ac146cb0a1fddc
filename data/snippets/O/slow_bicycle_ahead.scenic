# component: O
# description: A cyclist rides ahead of ego in the same lane at 4 m/s.
# paraphrases:
#   - slow bike in front of the car
#   - pedal cyclist on the carriageway
#   - somebody on a bicycle in front of me
#   - stuck behind a cyclist
# positions: [ahead]
# actions: [move_along]
# types: [bicycle]
# ---
bikeSpot = new OrientedPoint following roadDirection from egoSpot for 25
cyclist = new Bicycle at bikeSpot, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=4)
