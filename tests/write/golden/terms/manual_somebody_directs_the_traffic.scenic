## G: Clear weather, day, ego's light dark.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='signal', approach=94,
    ego_lane='rightmost'), speed=9))
EGO_TO_JUNCTION = 69.5  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h; it stops when it is at the stop line, then waits, then moves off.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do StopAtLine(line, place.lane, EGO_SPEED)  # stops
    do Stop(line, rate=3.5) for 1 seconds
    do Stop(line, rate=4) for 3 seconds  # waits
    do Drive(line, EGO_SPEED, rate=2)  # moves off

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

monitor TrafficLight():
    freezeTrafficLights()
    while True:
        setClosestTrafficLightStatus(ego, 'off')
        wait
require monitor TrafficLight()

## O1: A pedestrian at the right roadside, 60 m away; it stands still.
OFFICER_GAP = 60  # m, bumper to bumper
OFFICER_AT = EGO_AT + OFFICER_GAP + 2.85  # m along the lane; their bodies take 2.85
officer = new Pedestrian at beside(place.lane.rightEdge, place.lane, OFFICER_AT, 1.5),
    facing heading_at(place.lane, OFFICER_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*PEDESTRIANS)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
