## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An on-ramp of a motorway.
place = Uniform(*merges(approach=65))
EGO_TO_JUNCTION = 40  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 50.4 km/h; it accelerates 240 m before the merge_end.
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until self._lane is place.acceleration_lane and (distance from self to place.acceleration_lane.centerline[-1]) < 240
    do Drive(line, 22, rate=2.5) until self._lane is place.acceleration_lane  # accelerates
    line = route(place.left_lane)
    do Drive(line, 22)  # changes lane to the left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T: No restriction beyond the scene itself.
terminate after 45 seconds
