# goal: raise what escapes handlers
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
raise BaseException("x")
ego = new Car on Uniform(*network.lanes).centerline
