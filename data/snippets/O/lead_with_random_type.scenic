# component: O
# description: The vehicle ahead is a car or a van, drawn at random.
# paraphrases:
#   - leader of any kind
#   - a car or van drives in front of me
#   - some vehicle ahead in my lane
# positions: [ahead]
# actions: [keep_lane]
# types: [car, van, truck]
# ---
leaderSpot = new OrientedPoint following roadDirection from egoSpot for 25
leaderBlueprint = Uniform('vehicle.tesla.model3', 'vehicle.mercedes.sprinter', 'vehicle.audi.a2')
leader = new Car at leaderSpot, facing roadDirection,
    with blueprint leaderBlueprint,
    with behavior FollowLaneBehavior(target_speed=7)
