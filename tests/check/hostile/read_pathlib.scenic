# goal: read a file through a module that the model leaks
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
param stolen = pathlib.Path("SECRET").read_text()
ego = new Car on Uniform(*network.lanes).centerline
