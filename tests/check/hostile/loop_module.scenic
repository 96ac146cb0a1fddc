# goal: never end in the module body
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
while True:
    pass
ego = new Car on Uniform(*network.lanes).centerline
