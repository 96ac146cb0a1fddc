## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction.
place = Uniform(*motorways(length=475, min_length=64, lanes=2, speed=22.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h; it brakes, then follows the actor1 35 m from the actor1.
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do SlowTo(line, 18, rate=2)  # brakes
    do Drive(line, lambda: following_speed(self, actor1, EGO_SPEED, headway=1.41), rate=4)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the same lane, 12 m away, at 79.2 km/h.
ACTOR1_SPEED = 22  # m/s
ACTOR1_GAP = 12  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5
actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
