# goal: read the cells of a closure
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f(n):
    return lambda: n
x = f(1).__closure__
ego = new Car on Uniform(*network.lanes).centerline
