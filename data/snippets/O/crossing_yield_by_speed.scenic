# component: O
# description: A car on the side road slows down for ego and goes on when ego is past.
# paraphrases:
#   - cross traffic that surrenders priority
#   - the other car slows down and lets me go first
#   - a car from the side lets me through
# positions: [crossing_left]
# actions: [yield]
# types: [car]
# hosts: [R/intersection_with_crossing_traffic]
# ---
behavior SlowsForEgo(path, near):
    try:
        do FollowTrajectoryBehavior(target_speed=6, trajectory=path)
    interrupt when (distance from self to ego) < near and (ego can see self):
        take SetThrottleAction(0), SetBrakeAction(0.8)

yieldSpot = new OrientedPoint following roadDirection from sideManeuver.startLane.centerline[-1] for -25
yielder = new Car at yieldSpot, facing roadDirection,
    with behavior SlowsForEgo([sideManeuver.startLane, sideManeuver.connectingLane, sideManeuver.endLane], 25)
