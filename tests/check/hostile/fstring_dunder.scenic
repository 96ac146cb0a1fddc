# goal: read a dunder in an f-string
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = f"{network.__class__}"
ego = new Car on Uniform(*network.lanes).centerline
