## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=109,
    ego_lane='rightmost'), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A billboard at the right roadside, 60 m away.
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3.1  # m along the lane; their bodies take 3.1
actor1 = new Advertisement at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 2.4),
    facing heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint 'static.prop.advertisement',
    with rolename 'billboard',
    with length 1,
    with width 3,
    with height 3

## T: No restriction beyond the scene itself.
terminate after 20 seconds
