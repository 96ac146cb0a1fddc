# goal: reach the builtins
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = __builtins__
ego = new Car on Uniform(*network.lanes).centerline
