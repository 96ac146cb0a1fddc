## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, approach=65), speed=10))
EGO_TO_JUNCTION = 40  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 36 km/h; it brakes when it is 20 m before the stop line.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 20.3
    do Drive(line, EGO_SPEED / 2, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
