# component: O
# description: A car comes from the on-ramp and merges in front of ego on the motorway.
# paraphrases:
#   - joining vehicle from the slip road enters ego's lane
#   - entry-ramp merge ahead of the host
#   - a car entering the highway pushes in front of me
#   - traffic joining from a slip road
# positions: [on_ramp]
# actions: [cut_in]
# types: [car]
# hosts: [R/motorway_right_lane]
# ---
mergeWays = [m for i in network.intersections for m in i.maneuvers if m.startLane.road.is1Way and len(m.startLane.road.lanes) == 1 and len(m.endLane.road.lanes) >= 3 and m.endLane.road.is1Way]
mergeWay = Uniform(*mergeWays)
rampSpot = new OrientedPoint following roadDirection from mergeWay.startLane.centerline[-1] for -40

behavior MergesFromRamp(path, speed):
    do FollowTrajectoryBehavior(target_speed=speed, turn_speed=speed, trajectory=path)
    do FollowLaneBehavior(target_speed=speed)

merger = new Car at rampSpot, facing roadDirection,
    with behavior MergesFromRamp([mergeWay.startLane, mergeWay.connectingLane, mergeWay.endLane], 12)
