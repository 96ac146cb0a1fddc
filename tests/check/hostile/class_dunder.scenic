# goal: define a hook
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
class X:
    def __getattribute__(self, name):
        return 1
ego = new Car on Uniform(*network.lanes).centerline
