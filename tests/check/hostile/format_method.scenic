# goal: read a dunder by str.format
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = "{0.__class__.__init__.__globals__}".format(network)
ego = new Car on Uniform(*network.lanes).centerline
