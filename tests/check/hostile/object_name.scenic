# goal: reach the root class
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = object()
ego = new Car on Uniform(*network.lanes).centerline
