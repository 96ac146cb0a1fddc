param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearSunset'
model scenic.simulators.carla.model

ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
rider = new Motorcycle behind ego by Range(8, 15), with behavior FollowLaneBehavior(9)
