# component: O
# description: 'Three cars stand one behind the other ahead of ego: the end of a tailback.'
# paraphrases:
#   - tail of a traffic jam
#   - stationary queue of vehicles
#   - a standing line of cars, nothing moves
# positions: [ahead]
# actions: [stationary]
# types: [car]
# ---
lastSpot = new OrientedPoint following roadDirection from egoSpot for 40
middleSpot = new OrientedPoint following roadDirection from lastSpot for 8
firstSpot = new OrientedPoint following roadDirection from middleSpot for 8
last = new Car at lastSpot, facing roadDirection
middle = new Car at middleSpot, facing roadDirection
first = new Car at firstSpot, facing roadDirection
