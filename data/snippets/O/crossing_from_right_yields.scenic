# component: O
# description: A car from the right stops at the junction, lets ego pass and then crosses.
# paraphrases:
#   - gives way to the host at the crossroads
#   - waits its turn at the intersection
#   - the other driver lets me go first
#   - another car waits until I have passed the junction
# positions: [crossing_right]
# actions: [yield, go_straight]
# types: [car]
# hosts: [R/intersection_four_way]
# ---
waitWay = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers))
waitSpot = new OrientedPoint following roadDirection from waitWay.startLane.centerline[-1] for -12

behavior LetsEgoPass(path):
    while (distance from self to ego) < 60 and (distance past junction.centroid of ego) < 8:
        take SetBrakeAction(1), SetThrottleAction(0)
    do FollowTrajectoryBehavior(target_speed=6, trajectory=path)

waiter = new Car at waitSpot, facing roadDirection,
    with behavior LetsEgoPass([waitWay.startLane, waitWay.connectingLane, waitWay.endLane])
require 60 deg < (relative heading of waiter from ego) < 120 deg
