# goal: climb frames from a generator
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
g = (i for i in range(3))
x = g.gi_frame.f_back.f_builtins
ego = new Car on Uniform(*network.lanes).centerline
