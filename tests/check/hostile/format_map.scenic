# goal: read a dunder by format_map
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = "{a.__class__}".format_map({"a": 1})
ego = new Car on Uniform(*network.lanes).centerline
