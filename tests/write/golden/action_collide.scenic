## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*stretches(length=435, speed=20))
EGO_AT = Range(35, 55)  # m along its lane

## E
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()

## O1
RAMMER_SPEED = 18  # m/s
RAMMER_AT = EGO_AT - 20 - 5  # m along the lane

behavior RammerBehavior():
    line = way(place.lane)
    take SetSpeedAction(RAMMER_SPEED)
    do Drive(line, RAMMER_SPEED) until touch(self, ego)
    do Drive(line, 0, rate=6)

rammer = new Car at place.lane.centerline.pointAlongBy(RAMMER_AT),
    with blueprint Uniform(*CARS),
    with behavior RammerBehavior()

## T
terminate after 20 seconds
