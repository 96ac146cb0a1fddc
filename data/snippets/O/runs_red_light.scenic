# component: O
# description: A car from the side runs its red light and crosses the signalised intersection in front of ego.
# paraphrases:
#   - red-light violation by cross traffic
#   - vehicle ignores the signal
#   - another driver goes through a red traffic light
# positions: [crossing_left]
# actions: [run_red, go_straight]
# types: [car]
# hosts: [R/intersection_signalised]
# ---
violations = filter(lambda c: c.type is ManeuverType.STRAIGHT, egoManeuver.conflictingManeuvers)
violation = Uniform(*violations)
require violation.startLane.road is not egoManeuver.startLane.road
violatorSpot = new OrientedPoint following roadDirection from violation.startLane.centerline[-1] for -25

behavior RunsRed(path, speed):
    do FollowTrajectoryBehavior(target_speed=speed, turn_speed=speed, trajectory=path)
    do FollowLaneBehavior(target_speed=speed)

violator = new Car at violatorSpot, facing roadDirection,
    with behavior RunsRed([violation.startLane, violation.connectingLane, violation.endLane], 10)
