# goal: read the terminal
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = input()
ego = new Car on Uniform(*network.lanes).centerline
