## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A curve to the left, with an oncoming lane beside.
place = Uniform(*ordinary(curves('left', length=225, ego_lane='leftmost', oncoming=True,
    lanes=1), speed=9))
EGO_TO_BEND = 40  # m
EGO_AT = max(25, place.mark - EGO_TO_BEND)  # m along its lane

## E: Ego, a car, drives at 32.4 km/h; it gets into the opposite lane.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do Drive(line, EGO_SPEED, offset=3.5, shift=2) for 3 seconds
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: The run ends after 11 s.
terminate after 11 seconds
