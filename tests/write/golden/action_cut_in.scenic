## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*motorways(length=525, min_length=47, lanes=2, ego_lane='rightmost', speed=25))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, cutter) > 2.5:  # m/s2
        do BrakeFor(line, cutter)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
CUTTER_SPEED = 24  # m/s
CUTTER_AT = EGO_AT

behavior CutterBehavior():
    line = route(place.left_lane)
    take SetSpeedAction(CUTTER_SPEED)
    do Drive(line, CUTTER_SPEED) until ahead_by(self, ego, 0.76) > 17.6
    line = route(place.lane)
    do Drive(line, CUTTER_SPEED) for 2 seconds  # cuts in ahead of ego
    do Drive(line, 15.4, rate=4)  # brakes

cutter = new Car at place.left_lane.centerline.pointAlongBy(CUTTER_AT),
    with blueprint Uniform(*CARS),
    with behavior CutterBehavior()

## T
terminate after 20 seconds
