# component: E
# description: Ego is a police car on patrol at a drawn speed.
# paraphrases:
#   - squad car as the vehicle under test
#   - I drive a police car
#   - a patrol car under test
# actions: [keep_lane]
# types: [police_car]
# ---
patrolSpeed = TruncatedNormal(10, 1.5, 7, 13)
ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.dodge.charger_police',
    with behavior FollowLaneBehavior(target_speed=patrolSpeed)
