## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=375, min_length=112, speed=15), speed=13.9))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, wreck) > 2.5:  # m/s2
        do BrakeFor(line, wreck)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
WRECK_GAP = 60  # m, bumper to bumper
WRECK_AT = EGO_AT + WRECK_GAP + 5  # m along the lane; their bodies take 5
wreck = new Car at place.lane.centerline.pointAlongBy(WRECK_AT),
    with blueprint Uniform(*CARS)

## T
terminate after 20 seconds
