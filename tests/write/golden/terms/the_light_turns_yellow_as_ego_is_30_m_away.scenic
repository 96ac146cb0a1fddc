## G: Clear weather, day, ego's light green, then yellow when ego is 30 m before the stop line.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='signal', approach=85), speed=10))
EGO_TO_JUNCTION = 60  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 36 km/h.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until getClosestTrafficLightStatus(self) == 'yellow' and to_line(self, place.lane) > self.speed ** 2 / 10
    do StopAtLine(line, place.lane, EGO_SPEED)  # stops
    do Stop(line, rate=3.5)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

monitor TrafficLight():
    freezeTrafficLights()
    while not (to_line(ego, place.lane) < 30.3):
        setClosestTrafficLightStatus(ego, 'green')
        wait
    while True:
        setClosestTrafficLightStatus(ego, 'yellow')
        wait
require monitor TrafficLight()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
