# goal: import relatively
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from . import os
ego = new Car on Uniform(*network.lanes).centerline
