# goal: sample without end
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
require 1 > 2
ego = new Car on Uniform(*network.lanes).centerline
