# component: O
# description: A car on the opposite approach goes straight over the intersection towards ego.
# paraphrases:
#   - oncoming traffic at the junction
#   - vehicle from the far side continues ahead
#   - a car from the other side of the junction drives straight on
# positions: [opposite_approach]
# actions: [go_straight]
# types: [car]
# hosts: [R/intersection_opposite_approach]
# ---
oppositeSpot = new OrientedPoint following roadDirection from oppositeManeuver.startLane.centerline[-1] for -20
opposite = new Car at oppositeSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=8, turn_speed=8, trajectory=[oppositeManeuver.startLane, oppositeManeuver.connectingLane, oppositeManeuver.endLane])
