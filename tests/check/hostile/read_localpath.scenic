# goal: read a file through a path object
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
param stolen = localPath("SECRET").read_text()
ego = new Car on Uniform(*network.lanes).centerline
