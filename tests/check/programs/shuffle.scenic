param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

behavior Fast():
    do FollowLaneBehavior(9) for 2 seconds
behavior Easy():
    do FollowLaneBehavior(4) for 2 seconds
behavior Mixed():
    do shuffle Fast(), Easy()
    do choose {Fast(): 1, Easy(): 3}
    do FollowLaneBehavior(5)
ego = new Car on Uniform(*network.lanes).centerline, with behavior Mixed()
