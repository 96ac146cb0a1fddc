## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=82), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until slows_down(actor1)
    do Drive(line, 6, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 30 m away, at 43.2 km/h; it brakes.
ACTOR1_SPEED = 12  # m/s
ACTOR1_GAP = 30  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    do Drive(line, 6, rate=3)  # brakes

actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
