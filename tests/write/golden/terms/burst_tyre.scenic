## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction.
place = Uniform(*motorways(length=525, min_length=92, lanes=2, speed=22.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h; it brakes for what comes into its way.
EGO_SPEED = 22  # m/s

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

## O1: A car ahead of ego in the same lane, 40 m away, at 79.2 km/h; it loses control for a moment, then stops.
ACTOR1_SPEED = 22  # m/s
ACTOR1_GAP = 40  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) for 3 seconds
    do Skid(line, 1.8, 6) until self.speed < 0.2  # loses control for a moment
    do Stop(line, rate=3.5)  # stops

actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
