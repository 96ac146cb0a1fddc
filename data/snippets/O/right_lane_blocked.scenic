# component: O
# description: A car stands in the lane to the right of ego, so that ego cannot move over.
# paraphrases:
#   - blocked neighbouring lane on the outer side
#   - no way to move over to the right
#   - a car next to me on the right blocks that lane
# positions: [right_lane]
# actions: [stationary]
# types: [car]
# hosts: [R/road_left_of_two_lanes]
# ---
blockedSpot = new OrientedPoint following roadDirection from egoSpot for 30
blocker = new Car right of blockedSpot by 2.6, facing roadDirection
