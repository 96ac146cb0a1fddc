# goal: evaluate text through typing
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from typing import get_type_hints
ego = new Car on Uniform(*network.lanes).centerline
