## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection, where ego turns right, with a crosswalk.
place = Uniform(*ordinary(junctions(RIGHT_TURN, crosswalk=True, approach=60), speed=8))
EGO_TO_JUNCTION = 35  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 28.8 km/h; it turns right; it lets the actor1 pass.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED) until braking_needed(self, actor1) > 2 or actor1.speed > 0.3
        do Drive(line, lambda: short_of(self, line, [actor1], EGO_SPEED, 2.5, 4), rate=5) until passed(actor1, self, margin=2.5)
        do Drive(line, EGO_SPEED, rate=2) for 4 seconds
        do Drive(line, EGO_SPEED)  # turns right
    interrupt when braking_needed(self, actor1) > 3:  # m/s2
        do BrakeFor(line, actor1)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A pedestrian behind the intersection, on the road that ego takes; it crosses the road.
ACTOR1_SPEED = 1.4  # m/s
ACTOR1_AT = 4  # m behind the junction
ACTOR1_ARRIVES = Range(-0.2, 0)  # s after ego in the middle of its way, unhindered

behavior Actor1Behavior():
    line = route(place.lane, place.turn)
    do Stand() until sets_out(self, ego, line, ACTOR1_SPEED, ACTOR1_ARRIVES)
    do Walk(self.heading, ACTOR1_SPEED, to_far_side(self, line, self.heading))

actor1 = new Pedestrian at beside(place.exit_lane.group.rightEdge, place.exit_lane, ACTOR1_AT, 1.5),
    facing 90 deg relative to heading_at(place.exit_lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*PEDESTRIANS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
