# goal: reach os through a module of Scenic
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from scenic.syntax.translator import os
os.system("touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
