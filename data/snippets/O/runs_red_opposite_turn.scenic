# component: O
# description: A car on the opposite approach turns left against its red light.
# paraphrases:
#   - signal violation while turning across the host
#   - another driver turns although the traffic light is red
#   - a car from the other side turns in front of me against the red light
# positions: [opposite_approach]
# actions: [run_red, turn_left]
# types: [car]
# hosts: [R/intersection_signalised]
# ---
turnOptions = filter(lambda c: c.type is ManeuverType.LEFT_TURN, egoManeuver.conflictingManeuvers)
badTurn = Uniform(*turnOptions)
badSpot = new OrientedPoint following roadDirection from badTurn.startLane.centerline[-1] for -15
badTurner = new Car at badSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=7, trajectory=[badTurn.startLane, badTurn.connectingLane, badTurn.endLane])
require abs(relative heading of badTurner from ego) > 150 deg
