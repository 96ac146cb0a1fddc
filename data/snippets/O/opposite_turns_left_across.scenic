# component: O
# description: An oncoming car turns left at the intersection across ego's path.
# paraphrases:
#   - opposing driver cuts across in front of the host
#   - LTAP with the other vehicle turning
#   - a car from the other direction turns left right in front of me
# positions: [opposite_approach]
# actions: [turn_left]
# types: [car]
# hosts: [R/intersection_four_way]
# ---
crossTurns = filter(lambda c: c.type is ManeuverType.LEFT_TURN, egoManeuver.conflictingManeuvers)
crossTurn = Uniform(*crossTurns)
turnerSpot = new OrientedPoint following roadDirection from crossTurn.startLane.centerline[-1] for -15

behavior TurnsAcross(path, speed):
    do FollowTrajectoryBehavior(target_speed=speed, trajectory=path)
    do FollowLaneBehavior(target_speed=speed)

crossTurner = new Car at turnerSpot, facing roadDirection,
    with behavior TurnsAcross([crossTurn.startLane, crossTurn.connectingLane, crossTurn.endLane], 7)
require abs(relative heading of crossTurner from ego) > 150 deg
