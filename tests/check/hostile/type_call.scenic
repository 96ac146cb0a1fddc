# goal: make a class
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = type("X", (), {})
ego = new Car on Uniform(*network.lanes).centerline
