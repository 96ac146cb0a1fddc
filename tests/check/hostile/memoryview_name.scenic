# goal: reach memory
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = memoryview(b"x")
ego = new Car on Uniform(*network.lanes).centerline
