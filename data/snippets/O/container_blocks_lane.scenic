# component: O
# description: A container stands on the road and blocks the lane.
# paraphrases:
#   - skip left on the carriageway
# positions: [ahead]
# actions: [stationary]
# types: [container]
# ---
containerSpot = new OrientedPoint following roadDirection from egoSpot for 50
container = new Container at containerSpot, facing roadDirection
