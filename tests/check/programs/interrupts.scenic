param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

behavior Nervous():
    try:
        do FollowLaneBehavior(8)
    interrupt when simulation().currentTime > 20 and simulation().currentTime < 40:
        take SetBrakeAction(0.5)
    interrupt when self.speed > 9:
        take SetThrottleAction(0)
ego = new Car on Uniform(*network.lanes).centerline, with behavior Nervous()
