param map = localPath('town.xodr')
param carla_map = None
param weather = 'MidRainyNoon'
model scenic.simulators.carla.model

from math import pi, sin
count = 3
speed = Normal(8, 1)
kind = Discrete({'vehicle.audi.a2': 1, 'vehicle.tesla.model3': 2})
ego = new Car on Uniform(*network.lanes).centerline, with speed TruncatedNormal(6, 1, 4, 8), with blueprint kind
other = new Car following roadDirection from ego for Range(10, 10 + 10 * sin(pi / 2)), with speed speed
param count = DiscreteRange(1, count)
