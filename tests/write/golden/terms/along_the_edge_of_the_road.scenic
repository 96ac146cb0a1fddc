## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=88), speed=8))
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

## O1: A pedestrian partly in the lane at its right edge, 40 m away, at a walk; it moves along the road.
ACTOR1_SPEED = Range(1.2, 1.6)  # m/s
ACTOR1_GAP = 40  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 2.85  # m along the lane; their bodies take 2.85

behavior Actor1Behavior():
    do Walk(self.heading, ACTOR1_SPEED)

actor1 = new Pedestrian at beside(place.lane.centerline, place.lane, ACTOR1_AT, 1.6),
    with regionContainedIn everywhere,
    facing 180 deg relative to roadDirection,
    with blueprint Uniform(*PEDESTRIANS),
    with behavior Actor1Behavior()

## T: The run ends after 10 s.
terminate after 10 seconds
