# component: O
# description: A car comes from ego's left at the intersection and goes straight across ego's path.
# paraphrases:
#   - cross traffic from the left-hand side
#   - vehicle on the side street drives over the junction
#   - another car crosses in front of me from the left at a junction
# positions: [crossing_left]
# actions: [go_straight]
# types: [car]
# hosts: [R/intersection_with_crossing_traffic]
# ---
leftWays = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.STRAIGHT]
crossWay = Uniform(*leftWays)
crossSpot = new OrientedPoint following roadDirection from crossWay.startLane.centerline[-1] for -20
crosser = new Car at crossSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=8, turn_speed=8, trajectory=[crossWay.startLane, crossWay.connectingLane, crossWay.endLane])
require (distance from crosser to ego) < 90
require 60 deg < (relative heading of ego from crosser) < 120 deg
