# goal: change Scenic
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
setattr(network, "lanes", [])
ego = new Car on Uniform(*network.lanes).centerline
