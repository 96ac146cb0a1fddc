# component: O
# description: A car stands still in ego's lane, 30 to 45 metres ahead.
# paraphrases:
#   - broken-down vehicle blocks the lane
#   - motionless target on the path
#   - a dead car in the middle of my way
#   - a stopped vehicle that does not move at all
# positions: [ahead]
# actions: [stationary]
# types: [car]
# ---
stalledSpot = new OrientedPoint following roadDirection from egoSpot for Range(30, 45)
stalled = new Car at stalledSpot, facing roadDirection
