# component: O
# description: A warning sign stands at the right edge of the road, facing ego.
# paraphrases:
#   - traffic warning board beside the lane
#   - a sign at the side of the road warns of danger
#   - a triangular warning sign beside the lane
# positions: [roadside]
# actions: [stationary]
# types: [warning_sign]
# ---
signSpot = new OrientedPoint following roadDirection from egoSpot for 30
warningSign = new TrafficWarning right of signSpot by 2.6, facing 180 deg relative to signSpot.heading,
    with regionContainedIn None
