# component: O
# description: A pedestrian stands motionless in the middle of ego's lane.
# paraphrases:
#   - person does not move on the roadway
#   - static dummy target in the lane
#   - somebody just stands on the road
# positions: [ahead]
# actions: [stationary]
# types: [pedestrian]
# ---
standingSpot = new OrientedPoint following roadDirection from egoSpot for 40
standingPerson = new Pedestrian at standingSpot, facing Range(0, 360) deg,
    with regionContainedIn None
