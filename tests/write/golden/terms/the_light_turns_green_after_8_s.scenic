## G: Clear weather, day, ego's light red, then green when 8 s have passed.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego turns left.
place = Uniform(*ordinary(junctions(LEFT_TURN, control='signal', approach=65), speed=10))
EGO_TO_JUNCTION = 40  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 36 km/h; it turns left.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do StopAtLine(line, place.lane, EGO_SPEED)  # stops
    do Stop(line, rate=3.5) until getClosestTrafficLightStatus(self) == 'green'
    do SpeedUpTo(line, EGO_SPEED, rate=2)  # moves off
    do Drive(line, EGO_SPEED)  # turns left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

monitor TrafficLight():
    freezeTrafficLights()
    while not (clock() >= 8):
        setClosestTrafficLightStatus(ego, 'red')
        wait
    while True:
        setClosestTrafficLightStatus(ego, 'green')
        wait
require monitor TrafficLight()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
