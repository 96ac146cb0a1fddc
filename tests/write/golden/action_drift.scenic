## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=325, min_length=82, speed=15), speed=14))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
DRIFTER_SPEED = 14  # m/s
DRIFTER_GAP = 30  # m, bumper to bumper
DRIFTER_AT = EGO_AT + DRIFTER_GAP + 5  # m along the lane; their bodies take 5

behavior DrifterBehavior():
    line = route(place.lane)
    take SetSpeedAction(DRIFTER_SPEED)
    do Drive(line, DRIFTER_SPEED) for 3 seconds
    do Drive(line, DRIFTER_SPEED, offset=3.2, shift=0.7)

drifter = new Car at place.lane.centerline.pointAlongBy(DRIFTER_AT),
    with blueprint Uniform(*CARS),
    with behavior DrifterBehavior()

## T
terminate after 20 seconds
