## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway.
place = Uniform(*motorways(length=525, speed=25))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 90 km/h.
EGO_SPEED = 25  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car behind ego in the same lane, 8 m away, at 90 km/h; it follows ego 8 m from ego.
ACTOR1_SPEED = 25  # m/s
ACTOR1_GAP = 8  # m, bumper to bumper
ACTOR1_AT = EGO_AT - ACTOR1_GAP - 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(ACTOR1_SPEED)
        do Drive(line, lambda: following_speed(self, ego, ACTOR1_SPEED, headway=0.16), rate=4)
    interrupt when braking_needed(self, ego) > 3:  # m/s2
        do BrakeFor(line, ego)

actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
