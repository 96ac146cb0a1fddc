## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=275, min_length=120), speed=10))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 36 km/h; it stops with 4 m to the actor1.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do StopBefore(line, [actor1], room=4, rate=3.5)  # stops
    do Stop(line, rate=3.5)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A truck ahead of ego in the same lane, 70 m away; it stands still.
ACTOR1_GAP = 70  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 4.05  # m along the lane; their bodies take 4.05
actor1 = new Truck at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*TRUCKS)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
