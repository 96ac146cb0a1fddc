## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=225, min_length=92, oncoming=True, lanes=1), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, turner) > 2.5:  # m/s2
        do BrakeFor(line, turner)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
TURNER_SPEED = 6  # m/s
TURNER_GAP = 40  # m, bumper to bumper
TURNER_AT = EGO_AT + TURNER_GAP + 5  # m along the lane; their bodies take 5

behavior TurnerBehavior():
    line = route(place.lane)
    take SetSpeedAction(TURNER_SPEED)
    do Drive(line, TURNER_SPEED) for 3 seconds
    do TurnRound()  # turns round
    line = route(place.oncoming_lane)
    do Drive(line, 8)

turner = new Car at place.lane.centerline.pointAlongBy(TURNER_AT),
    with blueprint Uniform(*CARS),
    with behavior TurnerBehavior()

## T
terminate after 20 seconds
