# goal: never end in an expression
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = sum(i * i for i in range(10 ** 15))
ego = new Car on Uniform(*network.lanes).centerline
