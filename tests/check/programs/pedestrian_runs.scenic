param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

behavior Run(speed):
    take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)
    while True:
        wait
ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
walker = new Pedestrian right of ego by 4, facing 90 deg relative to roadDirection, with regionContainedIn None, with behavior Run(1.5)
terminate after 8 seconds
