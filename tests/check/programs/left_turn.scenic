param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

crossing = Uniform(*filter(lambda i: i.is4Way, network.intersections))
turns = filter(lambda m: m.type is ManeuverType.LEFT_TURN, crossing.maneuvers)
turn = Uniform(*turns)
way = [turn.startLane, turn.connectingLane, turn.endLane]
behavior Turn():
    do FollowTrajectoryBehavior(target_speed=6, trajectory=way)
ego = new Car on turn.startLane.centerline, with behavior Turn()
