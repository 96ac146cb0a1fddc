## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=475, least=55, lanes=2, ego_lane='rightmost', speed=22.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h; it brakes hard for what comes into its way.
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, actor1) > 5.6:
        do EmergencyStop(line, actor1)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the lane to the left, 3 m away, at 79.2 km/h; it cuts in ahead of ego 3 m from ego, then brakes hard.
ACTOR1_SPEED = 22  # m/s
ACTOR1_AT = EGO_AT + 3 + 5  # m along the lane

behavior Actor1Behavior():
    line = way(place.left_lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    line = way(place.lane)
    do Drive(line, ACTOR1_SPEED) for 2 seconds
    do Drive(line, 16, rate=4)

actor1 = new Car at place.left_lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
