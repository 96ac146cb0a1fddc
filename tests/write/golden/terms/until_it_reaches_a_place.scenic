## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, approach=135), speed=8))
EGO_TO_JUNCTION = 110  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 28.8 km/h; it accelerates until it is 25 m before the stop line, then brakes.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do Drive(line, 13, rate=2.5) until to_line(self, place.lane) < 25.3  # accelerates
    do Drive(line, 6, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
