param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

walk = Uniform(*network.sidewalks)
ego = new Car on Uniform(*network.lanes).centerline
walker = new Pedestrian on walk, with regionContainedIn None
require (distance from ego to walker) < 80
