# component: O
# description: A motorcycle comes straight on from the opposite side while ego turns left across its path.
# paraphrases:
#   - left turn across path with an oncoming bike
#   - a motorbike comes the other way while I turn left
# positions: [opposite_approach]
# actions: [go_straight]
# types: [motorcycle]
# hosts: [R/intersection_left_turn_with_opposing]
# ---
opposingSpot = new OrientedPoint following roadDirection from opposing.startLane.centerline[-1] for -Range(20, 30)
opposingRider = new Motorcycle at opposingSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=9, turn_speed=9, trajectory=[opposing.startLane, opposing.connectingLane, opposing.endLane])
