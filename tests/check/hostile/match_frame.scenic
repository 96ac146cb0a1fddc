# goal: read a frame by a class pattern
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
g = (i for i in range(3))
match g:
    case Exception(gi_frame=f):
        x = f
ego = new Car on Uniform(*network.lanes).centerline
