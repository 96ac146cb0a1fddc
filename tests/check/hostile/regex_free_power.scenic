# goal: compute a huge power
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = 7 ** (7 ** 12)
ego = new Car on Uniform(*network.lanes).centerline
