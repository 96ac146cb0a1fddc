# goal: fill the scene with objects
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
for i in range(10 ** 7):
    new Car on road
ego = new Car on Uniform(*network.lanes).centerline
