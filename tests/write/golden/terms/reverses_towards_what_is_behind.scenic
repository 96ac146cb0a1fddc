## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=199)))
EGO_AT = Range(49, 69)  # m along its lane

## E: Ego, a car, stands at first; it reverses until it is 2 m from the actor1, then stops.
EGO_SPEED = 0  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    do Backwards(1.5) until gap(self, actor1) < 2  # reverses
    do Backwards(0)  # stops

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car behind ego in the same lane, 14 m away; it stands still.
ACTOR1_GAP = 14  # m, bumper to bumper
ACTOR1_AT = EGO_AT - ACTOR1_GAP - 5  # m along the lane; their bodies take 5
actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
