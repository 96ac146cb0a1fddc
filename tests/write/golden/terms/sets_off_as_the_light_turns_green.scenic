## G: Clear weather, day, ego's light red, then green when 7 s have passed.
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

## E: Ego, a car, drives at 36 km/h; it follows who is ahead.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: following_speed(self, lead, EGO_SPEED, headway=0.8)) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do StopAtLine(line, place.lane, EGO_SPEED)  # stops
    do Stop(line, rate=3.5) until getClosestTrafficLightStatus(self) == 'green'
    do Drive(line, lambda: following_speed(self, lead, EGO_SPEED, headway=0.8), rate=2)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

monitor TrafficLight():
    freezeTrafficLights()
    while not (clock() >= 7):
        setClosestTrafficLightStatus(ego, 'red')
        wait
    while True:
        setClosestTrafficLightStatus(ego, 'green')
        wait
require monitor TrafficLight()

## O1: A car ahead of ego in the same lane, 12 m away, at 36 km/h; it stops, then moves off when the light before it is green, and 1 s later.
LEAD_SPEED = 10  # m/s
LEAD_GAP = 12  # m, bumper to bumper
LEAD_AT = EGO_AT + LEAD_GAP + 5  # m along the lane; their bodies take 5

behavior LeadBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(LEAD_SPEED)
    do Drive(line, LEAD_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do StopAtLine(line, place.lane, LEAD_SPEED)  # stops
    do Stop(line, rate=3.5) until getClosestTrafficLightStatus(self) == 'green'
    do Stop(line, rate=3.5) for 1 seconds
    do Drive(line, LEAD_SPEED, rate=2)  # moves off

lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior LeadBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
