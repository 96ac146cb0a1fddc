# goal: compile text
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = compile("1", "x", "exec")
ego = new Car on Uniform(*network.lanes).centerline
