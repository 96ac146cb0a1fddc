# component: O
# description: A road worker stands at the edge of the road beside cones.
# paraphrases:
#   - construction worker next to the lane
#   - a workman at the roadworks
#   - a worker stands next to the cones at the side of the road
# positions: [roadside]
# actions: [stationary]
# types: [pedestrian]
# ---
workPoint = new OrientedPoint following roadDirection from egoSpot for 35
worker = new Pedestrian right of workPoint by 2.4, with regionContainedIn None
workCone = new Cone at workPoint offset by (1.6, -3), with regionContainedIn None
