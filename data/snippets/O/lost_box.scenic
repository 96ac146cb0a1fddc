# component: O
# description: A box, lost cargo, lies in the middle of ego's lane.
# paraphrases:
#   - crate fallen off a lorry
#   - parcel on the roadway
#   - something that fell off a truck lies on the road
# positions: [ahead]
# actions: [stationary]
# types: [box, obstacle]
# ---
boxSpot = new OrientedPoint following roadDirection from egoSpot for 42
box = new Box at boxSpot
