## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=79), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A bicycle partly in the lane at its right edge, 30 m away, at 14.4 km/h; it moves along the road.
ACTOR1_SPEED = 4  # m/s
ACTOR1_GAP = 30  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3.5  # m along the lane; their bodies take 3.5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED, rate=2.4, offset=-1.6)

actor1 = new Bicycle at beside(place.lane.centerline, place.lane, ACTOR1_AT, 1.6),
    with regionContainedIn everywhere,
    facing heading_at(place.lane, ACTOR1_AT),
    with blueprint Uniform(*BICYCLES),
    with behavior Actor1Behavior()

## T: The run ends after 12 s.
terminate after 12 seconds
