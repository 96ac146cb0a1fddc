## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=74), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it follows who is ahead.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: following_speed(self, actor1, EGO_SPEED))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A bicycle ahead of ego in the same lane, 25 m away, at 18 km/h; it stops, then waits, then moves off at walking pace.
ACTOR1_SPEED = 5  # m/s
ACTOR1_GAP = 25  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3.5  # m along the lane; their bodies take 3.5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED, rate=2.4) for 3 seconds
    do Stop(line, rate=3.5) until self.speed < 0.2  # stops
    do Stop(line, rate=3.5) for 1 seconds
    do Stop(line, rate=4) for 3 seconds  # waits
    do Drive(line, 1.55, rate=2)  # moves off

actor1 = new Bicycle at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*BICYCLES),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
