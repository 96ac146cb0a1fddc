# component: E
# description: Ego uses the library behaviour that drives and avoids collisions with other vehicles.
# paraphrases:
#   - built-in collision avoidance
#   - drive but stay clear of other cars
#   - keep away from other cars
# reactions: [brake]
# ---
ego = new Car at egoSpot, facing roadDirection,
    with behavior DriveAvoidingCollisions(target_speed=9, avoidance_threshold=12)
