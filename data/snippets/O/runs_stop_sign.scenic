# component: O
# description: A car ignores its stop sign and drives into the unsignalised intersection.
# paraphrases:
#   - stop-sign violation at a crossroads
#   - does not halt before entering the junction
#   - another driver does not stop at the stop sign
# positions: [crossing_right]
# actions: [run_stop, go_straight]
# types: [car]
# hosts: [R/intersection_unsignalised]
# ---
ignoring = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers))
ignoreSpot = new OrientedPoint following roadDirection from ignoring.startLane.centerline[-1] for -22

behavior IgnoresStop(path):
    while True:
        do FollowTrajectoryBehavior(target_speed=9, turn_speed=9, trajectory=path)
        do FollowLaneBehavior(target_speed=9)

ignorer = new Car at ignoreSpot, facing roadDirection,
    with behavior IgnoresStop([ignoring.startLane, ignoring.connectingLane, ignoring.endLane])
require 60 deg < abs(relative heading of ignorer from ego) < 120 deg
