## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=118, speed=15), speed=14))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 50.4 km/h; it stops with 3 m to the load.
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do StopBefore(line, [load], room=3, rate=3.5)  # stops
    do Stop(line, rate=3.5)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A box ahead of ego in the same lane, 70 m away.
LOAD_GAP = 70  # m, bumper to bumper
LOAD_AT = EGO_AT + LOAD_GAP + 3  # m along the lane; their bodies take 3
load = new Box at place.lane.centerline.pointAlongBy(LOAD_AT),
    with blueprint Uniform(*BOXES),
    with regionContainedIn everywhere,
    facing roadDirection

## T: No restriction beyond the scene itself.
terminate after 20 seconds
