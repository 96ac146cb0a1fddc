## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=137), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes hard when the one and the two touch.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until touch(one, two)
    do Drive(line, EGO_SPEED / 2, rate=6)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 40 m away, at 43.2 km/h; it hits the two.
ONE_SPEED = 12  # m/s
ONE_GAP = 40  # m, bumper to bumper
ONE_AT = EGO_AT + ONE_GAP + 5  # m along the lane; their bodies take 5

behavior OneBehavior():
    line = route(place.lane)
    take SetSpeedAction(ONE_SPEED)
    do Drive(line, ONE_SPEED) until touch(self, two)  # hits the two
    do Stop(line, rate=6)

one = new Car at place.lane.centerline.pointAlongBy(ONE_AT),
    with blueprint Uniform(*CARS),
    with behavior OneBehavior()

## O2: A car ahead of the one in the same lane, 40 m away.
TWO_GAP = 40  # m, bumper to bumper
TWO_AT = ONE_AT + TWO_GAP + 5  # m along the lane; their bodies take 5

behavior TwoBehavior():
    line = route(place.lane)
    do Stop(line)

two = new Car at place.lane.centerline.pointAlongBy(TWO_AT),
    with blueprint Uniform(*CARS),
    with behavior TwoBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
