## G: Clear weather, day, ego's light green, then yellow when 2 s have passed, then red when 5 s have passed.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='signal', approach=95), speed=9))
EGO_TO_JUNCTION = 70  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h.
EGO_SPEED = 9  # m/s

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
    while not (clock() >= 2):
        setClosestTrafficLightStatus(ego, 'green')
        wait
    while not (clock() >= 5):
        setClosestTrafficLightStatus(ego, 'yellow')
        wait
    while True:
        setClosestTrafficLightStatus(ego, 'red')
        wait
require monitor TrafficLight()

## T: The run ends after 12 s.
terminate after 12 seconds
