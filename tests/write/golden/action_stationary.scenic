## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*stretches(length=375, least=112, speed=15))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, wreck) > 2.5:
        do BrakeFor(line, wreck)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()

## O1
WRECK_AT = EGO_AT + 60 + 5  # m along the lane
wreck = new Car at place.lane.centerline.pointAlongBy(WRECK_AT),
    with blueprint Uniform(*CARS)

## T
terminate after 20 seconds
