# component: O
# description: A truck comes from ego's right and crosses the intersection.
# paraphrases:
#   - heavy vehicle enters from the right-hand side road
#   - a truck crosses in front of me from the right at a junction
# positions: [crossing_right]
# actions: [go_straight]
# types: [truck]
# hosts: [R/intersection_four_way]
# ---
rightWays = filter(lambda m: m.type is ManeuverType.STRAIGHT, junction.maneuvers)
truckWay = Uniform(*rightWays)
truckStart = new OrientedPoint following roadDirection from truckWay.startLane.centerline[-1] for -18
crossingTruck = new Truck at truckStart, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=6, turn_speed=6, trajectory=[truckWay.startLane, truckWay.connectingLane, truckWay.endLane])
require 60 deg < (relative heading of crossingTruck from ego) < 120 deg
