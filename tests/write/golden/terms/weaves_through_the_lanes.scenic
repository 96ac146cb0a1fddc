## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 3 or more lanes in ego's direction, ego in the middle.
place = Uniform(*motorways(length=625, min_length=72, lanes=3, ego_lane='middle', speed=27.5))
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

## O1: A car ahead of ego in the same lane, 20 m away, at 97.2 km/h; it changes lane to the left, then changes lane to the right, then changes lane to the right.
ACTOR1_SPEED = 27  # m/s
ACTOR1_GAP = 20  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    line = route(place.left_lane)
    do Drive(line, ACTOR1_SPEED) for 2 seconds  # changes lane to the left
    line = route(place.lane)
    do Drive(line, ACTOR1_SPEED) for 2 seconds  # changes lane to the right
    line = route(place.right_lane)
    do Drive(line, ACTOR1_SPEED)  # changes lane to the right

actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
