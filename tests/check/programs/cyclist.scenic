param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

behavior Steady(speed):
    do FollowLaneBehavior(target_speed=speed)
ego = new Car on Uniform(*network.lanes).centerline, with behavior Steady(8)
bike = new Bicycle following roadDirection from ego for Range(20, 30), with behavior Steady(3)
