# goal: read a file
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
param stolen = open("SECRET").read()
ego = new Car on Uniform(*network.lanes).centerline
