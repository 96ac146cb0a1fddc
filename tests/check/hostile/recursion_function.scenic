# goal: recurse without end
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f(n):
    return f(n + 1) + 1
x = f(0)
ego = new Car on Uniform(*network.lanes).centerline
