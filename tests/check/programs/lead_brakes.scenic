param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

SPEED = 9
behavior Lead(speed, after):
    do FollowLaneBehavior(target_speed=speed) for after seconds
    while True:
        take SetThrottleAction(0), SetBrakeAction(0.7)
behavior Careful(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, gap):
        take SetThrottleAction(0), SetBrakeAction(1)
sections = filter(lambda s: s.centerline.length > 80, network.laneSections)
spot = new OrientedPoint on Uniform(*sections).centerline
ego = new Car at spot, with behavior Careful(SPEED, 12)
lead = new Car following roadDirection from ego for Range(15, 25), with behavior Lead(SPEED, Range(2, 4))
require (distance from ego to lead) > 10
terminate after 15 seconds
