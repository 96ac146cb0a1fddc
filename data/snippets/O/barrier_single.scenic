# component: O
# description: A single barrier stands in the middle of the lane.
# paraphrases:
#   - barricade on the path
#   - a barrier in my way
#   - road closed by a single barrier
# positions: [ahead]
# actions: [stationary]
# types: [barrier]
# ---
barrierSpot = new OrientedPoint following roadDirection from egoSpot for 40
barrier = new Barrier at barrierSpot, facing 90 deg relative to barrierSpot.heading
