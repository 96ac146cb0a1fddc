## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection, where ego goes straight on, 2 or more lanes in ego's direction, ego in the leftmost.
place = Uniform(*junctions(STRAIGHT, approach=60, lanes=2, ego_lane='leftmost'))
EGO_TO_JUNCTION = 35  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 28.8 km/h; it brakes for what comes into its way.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, actor1) > 2.5:  # m/s2
        do BrakeFor(line, actor1)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the lane to the right, 8 m away, at 28.8 km/h; it turns left.
ACTOR1_SPEED = 8  # m/s
ACTOR1_GAP = 8  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5
actor1 = new Car at place.right_lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.right_lane, LEFT_TURN), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
