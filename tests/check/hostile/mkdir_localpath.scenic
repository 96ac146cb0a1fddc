# goal: make a folder through a path object
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
localPath("MARK").mkdir()
ego = new Car on Uniform(*network.lanes).centerline
