# goal: walk to a class that opens files
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = ().__class__.__base__.__subclasses__()
ego = new Car on Uniform(*network.lanes).centerline
