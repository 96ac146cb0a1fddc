# goal: end the process
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
exit()
ego = new Car on Uniform(*network.lanes).centerline
