# component: E
# description: Ego brakes fully as soon as any visible object is less than 15 metres ahead.
# paraphrases:
#   - emergency stop for an obstacle in front
#   - collision avoidance by hard braking
#   - my car stops for whatever is in its way
# reactions: [brake]
# ---
behavior EgoBrakesForObjects(speed, distance):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, distance):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at egoSpot, facing roadDirection,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBrakesForObjects(10, 15)
