param map = localPath('town.xodr')
param carla_map = None
param weather = 'CloudySunset'
model scenic.simulators.carla.model

ego = new Car on Uniform(*filter(lambda s: s.centerline.length > 120, network.laneSections)).centerline
last = ego
for gap in (8, 9, 10):
    last = new Car following roadDirection from last for gap
