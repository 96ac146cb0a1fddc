param map = localPath('town.xodr')
param carla_map = None
param weather = 'WetNoon'
model scenic.simulators.carla.model

sections = filter(lambda s: s._laneToLeft is not None and s._laneToLeft.isForward == s.isForward, network.laneSections)
section = Uniform(*sections)
ego = new Car on section.centerline
left = new Car on section._laneToLeft.centerline, with behavior FollowLaneBehavior(7)
require 5 < (distance from ego to left) < 60
