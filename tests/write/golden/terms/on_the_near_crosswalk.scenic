## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection, where ego goes straight on, with a crosswalk.
place = Uniform(*ordinary(junctions(STRAIGHT, crosswalk=True, approach=61,
    ego_lane='rightmost'), speed=9))
EGO_TO_JUNCTION = 36  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h; it brakes for what comes into its way.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, actor1) > 3:  # m/s2
        do YieldTo(line, [actor1], EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A pedestrian on the right sidewalk; it crosses the road.
ACTOR1_SPEED = 1.4  # m/s
ACTOR1_AT = crosswalk_of(place.lane)
ACTOR1_ARRIVES = Range(-0.2, 0)  # s after ego in the middle of its way, unhindered

behavior Actor1Behavior():
    line = route(place.lane, place.turn)
    do Stand() until sets_out(self, ego, line, ACTOR1_SPEED, ACTOR1_ARRIVES)
    do Walk(self.heading, ACTOR1_SPEED, to_far_side(self, line, self.heading))

actor1 = new Pedestrian at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 3),
    facing 90 deg relative to heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*PEDESTRIANS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
