# goal: remove a file through a path object
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
localPath("SECRET").unlink()
ego = new Car on Uniform(*network.lanes).centerline
