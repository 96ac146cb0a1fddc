# goal: climb frames
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import inspect
x = inspect.stack()
ego = new Car on Uniform(*network.lanes).centerline
