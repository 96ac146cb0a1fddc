## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(junctions(LEFT_TURN, arms=4, control='signal', approach=69), speed=11))
EGO_TO_JUNCTION = 44  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## T
terminate after 20 seconds
