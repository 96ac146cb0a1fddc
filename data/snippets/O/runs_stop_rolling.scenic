# component: O
# description: A van rolls through the stop line and turns without stopping.
# paraphrases:
#   - rolling stop at the side road
#   - another driver hardly slows at the stop sign
#   - a van ignores the stop sign and turns
# positions: [crossing_left]
# actions: [run_stop, turn_right]
# types: [van]
# hosts: [R/intersection_with_crossing_traffic]
# ---
rollingWay = Uniform(*sideManeuver.startLane.maneuvers)
rollSpot = new OrientedPoint following roadDirection from rollingWay.startLane.centerline[-1] for -16
roller = new Van at rollSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=5, trajectory=[rollingWay.startLane, rollingWay.connectingLane, rollingWay.endLane])
