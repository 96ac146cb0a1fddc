# goal: take the namespace
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = locals()
ego = new Car on Uniform(*network.lanes).centerline
