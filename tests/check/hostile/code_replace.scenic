# goal: change the code of a function
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f():
    return 1
f.__code__ = (lambda: 2).__code__
ego = new Car on Uniform(*network.lanes).centerline
