## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=98,
    ego_lane='rightmost'), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A pedestrian on the right sidewalk, 50 m away; it crosses the road at a jog.
ACTOR1_SPEED = Range(2.2, 3)  # m/s
ACTOR1_GAP = 50  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 2.85  # m along the lane; their bodies take 2.85
ACTOR1_ARRIVES = Range(-1.29, -0.89)  # s after ego in the middle of its way, unhindered

behavior Actor1Behavior():
    line = route(place.lane)
    do Stand() until sets_out(self, ego, line, ACTOR1_SPEED, ACTOR1_ARRIVES)
    do Walk(self.heading, ACTOR1_SPEED, to_far_side(self, line, self.heading))

actor1 = new Pedestrian at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 3),
    facing 90 deg relative to heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*PEDESTRIANS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
