# goal: recurse through a lambda
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
f = lambda g: g(g)
x = f(f)
ego = new Car on Uniform(*network.lanes).centerline
