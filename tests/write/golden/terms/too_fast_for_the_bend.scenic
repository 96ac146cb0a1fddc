## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A curve to the right.
place = Uniform(*ordinary(curves('right', length=425, speed=20), speed=18.1))
EGO_TO_BEND = 40  # m
EGO_AT = max(25, place.mark - EGO_TO_BEND)  # m along its lane

## E: Ego, a car, drives too fast; it loses control for a moment when it is 5 m before the bend.
EGO_SPEED = Range(16.7, 19.5)  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until along(place.lane, self.position) + self.length / 2 > place.mark - 5
    do Skid(line, 1.8, 6) for 1.2 seconds  # loses control for a moment
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
