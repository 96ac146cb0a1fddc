# goal: delete a dunder name
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
del __name__
ego = new Car on Uniform(*network.lanes).centerline
