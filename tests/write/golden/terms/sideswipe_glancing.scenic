## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=475, min_length=47, lanes=2, ego_lane='rightmost', speed=22.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h.
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car abreast of ego in the lane to the left, at 79.2 km/h; it drifts out of the lane to the right, then hits ego with its right at the left of ego.
ACTOR1_SPEED = 22  # m/s
ACTOR1_AT = EGO_AT

behavior Actor1Behavior():
    line = route(place.left_lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    do Drive(line, ACTOR1_SPEED, offset=-3.2, shift=0.7) until touch(self, ego)
    do Drive(line, ACTOR1_SPEED) until touch(self, ego)  # hits ego
    do Stop(line, rate=6)

actor1 = new Car at place.left_lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
