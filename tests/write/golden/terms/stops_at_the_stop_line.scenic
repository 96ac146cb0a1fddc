## G: Clear weather, day, ego's light red.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='signal', approach=65), speed=10))
EGO_TO_JUNCTION = 40  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 36 km/h; it stops when it is at the stop line.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do StopAtLine(line, place.lane, EGO_SPEED)  # stops
    do Stop(line, rate=3.5)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn, 'red')  # in CARLA: ego's is red

## T: No restriction beyond the scene itself.
terminate after 20 seconds
