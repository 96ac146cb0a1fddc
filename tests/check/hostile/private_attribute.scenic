# goal: reach private state
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = network._uidForIndex
ego = new Car on Uniform(*network.lanes).centerline
