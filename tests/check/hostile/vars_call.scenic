# goal: take the namespace
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = vars()
ego = new Car on Uniform(*network.lanes).centerline
