# goal: never end in a requirement
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f():
    while True:
        pass
require f()
ego = new Car on Uniform(*network.lanes).centerline
