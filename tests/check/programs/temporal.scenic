param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(5)
other = new Car following roadDirection from ego for Range(20, 40)
require always (distance from ego to other) > 1
require eventually ego.speed > 0
record ego.speed as speed
record initial ego.position as begin
record final ego.position as end
terminate after 5 seconds
