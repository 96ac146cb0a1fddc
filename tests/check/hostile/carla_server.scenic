# goal: connect to a simulator
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = CarlaSimulator(None, None)
ego = new Car on Uniform(*network.lanes).centerline
