# goal: reach the globals of a lambda
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = (lambda: 0).__globals__
ego = new Car on Uniform(*network.lanes).centerline
