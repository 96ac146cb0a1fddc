# component: O
# description: Six cones form a taper that narrows ego's lane from the right.
# paraphrases:
#   - merging taper before a lane closure
#   - diagonal line of cones closes the lane
#   - traffic cones in a slanting line lead me out of the lane
# positions: [ahead]
# actions: [stationary]
# types: [cone, lane_closure]
# ---
taperStart = new OrientedPoint following roadDirection from egoSpot for 40
for k in range(6):
    new Cone at taperStart offset by (1.8 - 0.6 * k, 2.5 * k), with regionContainedIn None
