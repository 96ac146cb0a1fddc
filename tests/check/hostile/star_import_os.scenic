# goal: import all of a module
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from os import *
ego = new Car on Uniform(*network.lanes).centerline
