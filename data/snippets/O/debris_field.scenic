# component: O
# description: Three pieces of debris are scattered over ego's lane at random offsets.
# paraphrases:
#   - spread-out wreckage
#   - wreckage after an accident spread over the road
# positions: [ahead]
# actions: [stationary]
# types: [debris]
# ---
fieldSpot = new OrientedPoint following roadDirection from egoSpot for 40
pieceA = new Debris at fieldSpot offset by (Range(-1.2, 1.2), 0)
pieceB = new Debris at fieldSpot offset by (Range(-1.2, 1.2), 4)
pieceC = new Debris at fieldSpot offset by (Range(-1.2, 1.2), 8)
