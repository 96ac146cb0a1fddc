## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=132), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes when the one is 2.5 s from the two.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until ttc(one, two) < 2.5
    do Drive(line, EGO_SPEED / 2, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 30 m away, at 43.2 km/h.
ONE_SPEED = 12  # m/s
ONE_GAP = 30  # m, bumper to bumper
ONE_AT = EGO_AT + ONE_GAP + 5  # m along the lane; their bodies take 5

behavior OneBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(ONE_SPEED)
        do Drive(line, ONE_SPEED)
    interrupt when braking_needed(self, two) > 3:  # m/s2
        do BrakeFor(line, two)

one = new Car at place.lane.centerline.pointAlongBy(ONE_AT),
    with blueprint Uniform(*CARS),
    with behavior OneBehavior()

## O2: A car ahead of the one in the same lane, 45 m away, at 10.8 km/h.
TWO_SPEED = 3  # m/s
TWO_GAP = 45  # m, bumper to bumper
TWO_AT = ONE_AT + TWO_GAP + 5  # m along the lane; their bodies take 5
two = new Car at place.lane.centerline.pointAlongBy(TWO_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), TWO_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
