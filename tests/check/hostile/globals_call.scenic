# goal: take the namespace
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = globals()["__builtins__"]
ego = new Car on Uniform(*network.lanes).centerline
