param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

ego = new Car on Uniform(*network.lanes).centerline
other = new Car visible, with requireVisible True
require[0.5] (distance from ego to other) > 20
require (relative heading of other from ego) < 3.2
