param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

ego = new Car on Uniform(*network.lanes).centerline
other = new Car following roadDirection from ego for 20
mutate ego, other by 0.1
