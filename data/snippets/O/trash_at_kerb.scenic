# component: O
# description: A trash can stands at the kerb.
# paraphrases:
#   - litter bin by the road
#   - a rubbish bin at the side of the street
#   - a dustbin at the edge of the road
# positions: [roadside]
# actions: [stationary]
# types: [trash]
# ---
binSpot = new OrientedPoint following roadDirection from egoSpot for 25
bin = new Trash right of binSpot by 3, with regionContainedIn None
