## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=175, min_length=62), speed=6))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 21.6 km/h; it follows who is ahead.
EGO_SPEED = 6  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: following_speed(self, actor1, EGO_SPEED, headway=1))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 10 m away, at 21.6 km/h; it stops, then waits, then moves off, then stops.
ACTOR1_SPEED = 6  # m/s
ACTOR1_GAP = 10  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    do Stop(line, rate=3.5) until self.speed < 0.2  # stops
    do Stop(line, rate=3.5) for 1 seconds
    do Stop(line, rate=4) for 2 seconds  # waits
    do SpeedUpTo(line, ACTOR1_SPEED, rate=2)  # moves off
    do Stop(line, rate=3.5)  # stops

actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
