# goal: use a metaclass
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
class M:
    pass
class X(metaclass=M):
    pass
ego = new Car on Uniform(*network.lanes).centerline
