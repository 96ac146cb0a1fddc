# goal: fill memory with a list
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = [0] * (10 ** 11)
ego = new Car on Uniform(*network.lanes).centerline
