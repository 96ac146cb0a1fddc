# goal: end the process by an exception
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
raise SystemExit
ego = new Car on Uniform(*network.lanes).centerline
