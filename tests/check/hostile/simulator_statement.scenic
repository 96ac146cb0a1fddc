# goal: have a simulator factory of its own
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
simulator (lambda: 3)()
ego = new Car on Uniform(*network.lanes).centerline
