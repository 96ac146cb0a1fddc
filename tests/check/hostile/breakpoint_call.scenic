# goal: stop in a debugger
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
breakpoint()
ego = new Car on Uniform(*network.lanes).centerline
