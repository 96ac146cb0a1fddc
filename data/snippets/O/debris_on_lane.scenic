# component: O
# description: Debris lies on ego's lane.
# paraphrases:
#   - rubbish strewn over the carriageway
#   - fragments on the road surface
#   - wreckage and parts lie on the road
# positions: [ahead]
# actions: [stationary]
# types: [debris]
# ---
debrisSpot = new OrientedPoint following roadDirection from egoSpot for Range(30, 50)
debris = new Debris at debrisSpot
