# goal: compute a huge shift
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = 1 << (10 ** 11)
ego = new Car on Uniform(*network.lanes).centerline
