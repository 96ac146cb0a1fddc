# component: O
# description: A container stands at the right edge and reaches into the lane.
# paraphrases:
#   - dumpster protrudes from the kerb
#   - a container at the side sticks out into my lane
#   - something large at the edge takes part of my lane
# positions: [partly_in_lane]
# actions: [stationary]
# types: [container]
# ---
skipSpot = new OrientedPoint following roadDirection from egoSpot for 40
skip = new Container right of skipSpot by 0.8, facing roadDirection, with regionContainedIn None
