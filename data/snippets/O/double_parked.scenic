# component: O
# description: A van stands half in ego's lane at its right edge.
# paraphrases:
#   - badly parked vehicle sticks out into the carriageway
#   - partially blocking the lane
#   - a delivery van parked in the second row, half in my way
# positions: [partly_in_lane]
# actions: [stationary]
# types: [van]
# hosts: [R/road_with_parking_lane]
# ---
edgeSpot = new OrientedPoint following roadDirection from egoSpot for Range(30, 40)
halfIn = new Van right of edgeSpot by 0.6, facing roadDirection, with regionContainedIn None
