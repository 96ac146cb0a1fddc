param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

behavior Guarded():
    precondition: self.lane is not None
    do FollowLaneBehavior(5) until self.speed > 100
ego = new Car on Uniform(*network.lanes).centerline, with behavior Guarded()
