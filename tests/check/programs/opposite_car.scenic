param map = localPath('town.xodr')
param carla_map = None
param weather = 'CloudyNoon'
model scenic.simulators.carla.model

crossing = network.intersections[0]
straight = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, crossing.maneuvers))
other = Uniform(*straight.conflictingManeuvers)
ego = new Car on straight.startLane.centerline, with behavior FollowTrajectoryBehavior(7, [straight.startLane, straight.connectingLane, straight.endLane])
rival = new Truck on other.startLane.centerline, with behavior FollowTrajectoryBehavior(6, [other.startLane, other.connectingLane, other.endLane])
terminate when (distance from ego to rival) > 90
