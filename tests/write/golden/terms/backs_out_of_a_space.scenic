## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=100, ego_lane='rightmost',
    shoulder='preferred'), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it brakes for what comes into its way.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, actor1) > 2.5:  # m/s2
        do BrakeFor(line, actor1)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car parked on the right, 50 m away; it reverses.
ACTOR1_GAP = 50  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3.7  # m along the lane; their bodies take 3.7

behavior Actor1Behavior():
    line = route(place.lane)
    do Stop(line) until sets_out(self, ego, line, 2, 0.48, 3)
    do Backwards(2) for 2 seconds  # reverses
    do Backwards(0)

actor1 = new Car at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 3.6),
    facing -90 deg relative to heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
