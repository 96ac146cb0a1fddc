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
SLIDER_SPEED = 14  # m/s
SLIDER_GAP = 30  # m, bumper to bumper
SLIDER_AT = EGO_AT + SLIDER_GAP + 5  # m along the lane; their bodies take 5

behavior SliderBehavior():
    line = route(place.lane)
    take SetSpeedAction(SLIDER_SPEED)
    do Drive(line, SLIDER_SPEED) for 3 seconds
    do Skid(line, -1.8, 6) for 1.2 seconds  # loses control for a moment
    do Drive(line, SLIDER_SPEED)

slider = new Car at place.lane.centerline.pointAlongBy(SLIDER_AT),
    with blueprint Uniform(*CARS),
    with behavior SliderBehavior()

## T
terminate after 20 seconds
