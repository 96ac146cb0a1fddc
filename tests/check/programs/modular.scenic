param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

scenario Traffic(gap):
    setup:
        ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
        lead = new Car following roadDirection from ego for gap
        terminate after 6 seconds
scenario Main():
    setup:
        ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
        lead = new Car following roadDirection from ego for 25
