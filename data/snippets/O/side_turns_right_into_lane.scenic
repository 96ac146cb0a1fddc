# component: O
# description: A car from the right turns right into the road that ego continues on.
# paraphrases:
#   - merges from the side road in the same direction
#   - pulls out of a side street ahead of the host
#   - a car turns out of the side road into my road
# positions: [crossing_right]
# actions: [turn_right]
# types: [car]
# hosts: [R/intersection_four_way]
# ---
rightTurns = filter(lambda m: m.type is ManeuverType.RIGHT_TURN, junction.maneuvers)
rightTurn = Uniform(*rightTurns)
rightSpot = new OrientedPoint following roadDirection from rightTurn.startLane.centerline[-1] for -10
rightTurner = new Car at rightSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=6, trajectory=[rightTurn.startLane, rightTurn.connectingLane, rightTurn.endLane])
require 60 deg < abs(relative heading of rightTurner from ego) < 120 deg
