# goal: reach a dunder by getattr
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = getattr((), "__class__")
ego = new Car on Uniform(*network.lanes).centerline
