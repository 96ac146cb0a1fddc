# component: O
# description: An obstacle of a random kind (barrel, box or creased box) lies ahead.
# paraphrases:
#   - some unidentified object in the way
#   - an object in my way
#   - something lies on the road in front of me
# positions: [ahead]
# actions: [stationary]
# types: [obstacle, barrel, trash]
# ---
obstacleSpot = new OrientedPoint following roadDirection from egoSpot for 40
obstacle = new Prop at obstacleSpot,
    with blueprint Uniform('static.prop.barrel', 'static.prop.box01', 'static.prop.creasedbox01')
