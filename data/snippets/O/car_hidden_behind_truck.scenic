# component: O
# description: A stationary car is hidden from ego by a truck that drives between them.
# paraphrases:
#   - obstructed sight of a standing vehicle
#   - a standing car that I cannot see because of a truck
# positions: [ahead]
# actions: [stationary]
# types: [car, truck]
# ---
shadowSpot = new OrientedPoint following roadDirection from egoSpot for 70
shadowed = new Car at shadowSpot, facing roadDirection
cover = new Truck ahead of ego by 12, with behavior FollowLaneBehavior(target_speed=7)
