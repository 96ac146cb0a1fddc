## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An on-ramp of a motorway.
place = Uniform(*merges(approach=89))
EGO_TO_JUNCTION = 64  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 57.6 km/h; it follows who is ahead.
EGO_SPEED = 16  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: following_speed(self, actor1, EGO_SPEED)) until self._lane is place.acceleration_lane
    line = route(place.left_lane)
    do Drive(line, lambda: following_speed(self, actor1, EGO_SPEED, points=line))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A truck ahead of ego in the same lane, 35 m away, at 57.6 km/h; it brakes.
ACTOR1_SPEED = 16  # m/s
ACTOR1_GAP = 35  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 6.55  # m along the lane; their bodies take 6.55

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED, rate=2.4) for 3 seconds
    do Drive(line, 9, rate=3)  # brakes

actor1 = new Truck at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*TRUCKS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
