# goal: make processes without end
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from os import fork
while True:
    fork()
ego = new Car on Uniform(*network.lanes).centerline
