param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

monitor Watch(limit):
    while True:
        if simulation().currentTime > limit:
            terminate
        wait
ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(5)
require monitor Watch(60)
