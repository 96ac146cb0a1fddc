# goal: set a dunder property of an object
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
ego = new Car on road, with __class__ 3
