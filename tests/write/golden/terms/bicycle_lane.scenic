## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*stretches(straight=True, length=225, min_length=46, lanes=2, ego_lane='leftmost',
    shoulder=True))
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

## O1: A bicycle beside ego on the right, 1.2 m to the side, at 21.6 km/h.
ACTOR1_SPEED = 6  # m/s
ACTOR1_AT = EGO_AT
actor1 = new Bicycle at beside(place.right_lane.centerline, place.right_lane, ACTOR1_AT, -0.75),
    with regionContainedIn everywhere,
    facing heading_at(place.right_lane, ACTOR1_AT),
    with blueprint Uniform(*BICYCLES),
    with behavior Cruise(route(place.right_lane), ACTOR1_SPEED)

## T: The run ends after 10 s.
terminate after 10 seconds
