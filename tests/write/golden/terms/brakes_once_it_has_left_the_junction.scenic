## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection, where ego turns left.
place = Uniform(*ordinary(junctions(LEFT_TURN, approach=60), speed=8))
EGO_TO_JUNCTION = 35  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 28.8 km/h; it turns left, then brakes when it is past the intersection.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until self._intersection  # turns left
    do Drive(line, EGO_SPEED) until has_crossed(self)
    do Drive(line, EGO_SPEED / 2, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
