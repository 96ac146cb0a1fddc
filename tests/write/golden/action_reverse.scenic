## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=225, min_length=102), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, backer) > 2.5:  # m/s2
        do BrakeFor(line, backer)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
BACKER_SPEED = 3  # m/s
BACKER_GAP = 50  # m, bumper to bumper
BACKER_AT = EGO_AT + BACKER_GAP + 5  # m along the lane; their bodies take 5

behavior BackerBehavior():
    line = route(place.lane)
    take SetSpeedAction(BACKER_SPEED)
    do Backwards(3)

backer = new Car at place.lane.centerline.pointAlongBy(BACKER_AT),
    with blueprint Uniform(*CARS),
    with behavior BackerBehavior()

## T
terminate after 20 seconds
