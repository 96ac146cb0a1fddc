# component: O
# description: A car from a side road turns left into the intersection ahead of ego.
# paraphrases:
#   - vehicle turns out of the side street to its left
#   - a car turns out of the side road to the left
#   - a car comes out of a side street and turns left in front of me
# positions: [crossing_right]
# actions: [turn_left]
# types: [car]
# hosts: [R/intersection_four_way]
# ---
lefts = filter(lambda m: m.type is ManeuverType.LEFT_TURN, junction.maneuvers)
sideLeft = Uniform(*lefts)
sideLeftSpot = new OrientedPoint at sideLeft.startLane.centerline.pointAlongBy(sideLeft.startLane.centerline.length - 14), facing roadDirection
sideLeftCar = new Car at sideLeftSpot, facing roadDirection,
    with behavior FollowTrajectoryBehavior(target_speed=6, trajectory=[sideLeft.startLane, sideLeft.connectingLane, sideLeft.endLane])
require 60 deg < abs(relative heading of sideLeftCar from ego) < 120 deg
