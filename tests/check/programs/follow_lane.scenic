param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

lane = Uniform(*network.lanes)
spot = new OrientedPoint on lane.centerline
ego = new Car at spot, with behavior FollowLaneBehavior(target_speed=8)
