## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=435, speed=20), speed=10))
EGO_AT = Range(35, 55)  # m along its lane

## E
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
RAMMER_SPEED = 18  # m/s
RAMMER_GAP = 20  # m, bumper to bumper
RAMMER_AT = EGO_AT - RAMMER_GAP - 5  # m along the lane; their bodies take 5

behavior RammerBehavior():
    line = route(place.lane)
    take SetSpeedAction(RAMMER_SPEED)
    do Drive(line, RAMMER_SPEED) until touch(self, ego)  # hits ego
    do Stop(line, rate=6)

rammer = new Car at place.lane.centerline.pointAlongBy(RAMMER_AT),
    with blueprint Uniform(*CARS),
    with behavior RammerBehavior()

## T
terminate after 20 seconds
