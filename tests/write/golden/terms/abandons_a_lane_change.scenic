## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction.
place = Uniform(*motorways(length=575, min_length=72, lanes=2, ego_lane='rightmost', speed=25))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 90 km/h.
EGO_SPEED = 25  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the lane to the left, 20 m away, at 90 km/h; it begins to cut in ahead of ego and break off.
ACTOR1_SPEED = 25  # m/s
ACTOR1_GAP = 20  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.left_lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    do Drive(line, ACTOR1_SPEED, offset=-1.7) for 1.5 seconds
    do Drive(line, ACTOR1_SPEED)

actor1 = new Car at place.left_lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
