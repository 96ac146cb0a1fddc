# goal: take the format method as a value
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
f = "{0.__class__}".format
x = f(3)
ego = new Car on Uniform(*network.lanes).centerline
