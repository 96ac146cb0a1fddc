# goal: find objects through the collector
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import gc
x = gc.get_objects()
ego = new Car on Uniform(*network.lanes).centerline
