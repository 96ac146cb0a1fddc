## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=245), speed=8))
EGO_AT = Range(45, 65)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it stops, then reverses.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do Stop(line, rate=3.5) until self.speed < 0.2  # stops
    do Stop(line, rate=3.5) for 1 seconds
    do Backwards(1)  # reverses

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
