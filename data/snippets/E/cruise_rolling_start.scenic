# component: E
# description: Ego already rolls at 13 m/s when the run begins and keeps that speed.
# paraphrases:
#   - initial velocity equals target velocity
#   - flying start, no acceleration phase
#   - my car is moving already at the start
# actions: [keep_lane]
# ---
EGO_SPEED = 13
ego = new Car at egoSpot, facing roadDirection,
    with velocity Vector(0, EGO_SPEED).rotatedBy(egoSpot.heading),
    with behavior FollowLaneBehavior(target_speed=EGO_SPEED)
