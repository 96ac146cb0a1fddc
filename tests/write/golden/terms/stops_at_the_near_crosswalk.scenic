## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection without lights or signs, where ego goes straight on, with a crosswalk.
place = Uniform(*ordinary(junctions(STRAIGHT, crosswalk=True, control='none',
    approach=61), speed=9))
EGO_TO_JUNCTION = 36  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h; it stops 2 m before the crosswalk.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 2.3
    do Stop(line, rate=3.5)  # stops

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
