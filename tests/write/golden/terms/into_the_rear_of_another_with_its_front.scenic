## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=92, speed=15), speed=14))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 50.4 km/h; it hits the actor1 with its front at the rear of the actor1.
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until touch(self, actor1)  # hits the actor1
    do Stop(line, rate=6)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 40 m away, at 21.6 km/h.
ACTOR1_SPEED = 6  # m/s
ACTOR1_GAP = 40  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5
actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
