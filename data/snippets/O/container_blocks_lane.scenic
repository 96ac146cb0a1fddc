# component: O
# description: A container stands on the road and blocks the lane.
# paraphrases:
#   - skip left on the carriageway
#   - a big container stands in my way
#   - the lane is blocked by a large metal box
# positions: [ahead]
# actions: [stationary]
# types: [container]
# ---
containerSpot = new OrientedPoint following roadDirection from egoSpot for 50
container = new Container at containerSpot, facing roadDirection
