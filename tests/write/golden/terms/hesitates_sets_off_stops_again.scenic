## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225)))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, stands at first; it moves off, then stops, then waits, then moves off.
EGO_SPEED = 0  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    do Drive(line, EGO_SPEED) for 3 seconds
    do SpeedUpTo(line, 3, rate=2)  # moves off
    do Stop(line, rate=3.5) until self.speed < 0.2  # stops
    do Stop(line, rate=3.5) for 1 seconds
    do Stop(line, rate=4) for 2 seconds  # waits
    do Drive(line, 8, rate=2)  # moves off

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
