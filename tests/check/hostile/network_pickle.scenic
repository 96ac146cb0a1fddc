# goal: load a pickle as a network
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
n = Network.fromPickle("SECRET")
ego = new Car on Uniform(*network.lanes).centerline
