## G: Clear weather, day, ego's light flashing.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='signal', approach=61), speed=9))
EGO_TO_JUNCTION = 36  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

monitor TrafficLight():
    freezeTrafficLights()
    while True:
        setClosestTrafficLightStatus(ego, 'yellow' if clock() % 1 < 0.5 else 'off')
        wait
require monitor TrafficLight()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
