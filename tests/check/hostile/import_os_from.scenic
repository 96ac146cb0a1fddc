# goal: run a command
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from os import system
system("touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
