# goal: read a dunder by a class pattern
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
match 3:
    case int(__class__=c):
        x = c
ego = new Car on Uniform(*network.lanes).centerline
