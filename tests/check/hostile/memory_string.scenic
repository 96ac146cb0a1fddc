# goal: fill memory with a string
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = "a" * (10 ** 11)
ego = new Car on Uniform(*network.lanes).centerline
