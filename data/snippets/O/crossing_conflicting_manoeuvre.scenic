# component: O
# description: A car takes a manoeuvre that conflicts with ego's at the crossroads.
# paraphrases:
#   - crossing paths with another vehicle at the junction
#   - straight crossing path conflict
#   - another car crosses my way at a junction
# positions: [crossing_left, crossing_right]
# actions: [go_straight]
# types: [car]
# hosts: [R/intersection_with_crossing_traffic]
# ---
sideSpot = new OrientedPoint following roadDirection from sideManeuver.startLane.centerline[-1] for -Range(15, 25)
sider = new Car at sideSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=8, turn_speed=8, trajectory=[sideManeuver.startLane, sideManeuver.connectingLane, sideManeuver.endLane])
