# goal: fill memory step by step
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = [0]
while True:
    x = x + x
ego = new Car on Uniform(*network.lanes).centerline
