## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=475, min_length=55, lanes=2, ego_lane='rightmost', speed=22.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h; it brakes hard for what comes into its way.
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, actor1) > 5.6:  # m/s2
        do EmergencyStop(line, actor1)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the lane to the left, 3 m away, at 79.2 km/h; it cuts in ahead of ego 3 m from ego, then brakes hard.
ACTOR1_SPEED = 22  # m/s
ACTOR1_GAP = 3  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.left_lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    line = route(place.lane)
    do Drive(line, ACTOR1_SPEED) for 2 seconds  # cuts in ahead of ego
    do Drive(line, 16, rate=4)  # brakes

actor1 = new Car at place.left_lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
