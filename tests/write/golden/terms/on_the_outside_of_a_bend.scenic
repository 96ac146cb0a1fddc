## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A curve to the right.
place = Uniform(*ordinary(curves('right', length=375, min_length=114, ego_lane='leftmost',
    oncoming=True, shoulder='preferred', speed=15), speed=9))
EGO_TO_BEND = 40  # m
EGO_AT = max(25, place.mark - EGO_TO_BEND)  # m along its lane

## E: Ego, a car, drives at 32.4 km/h.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A van parked on the left, 60 m away.
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5.55  # m along the lane; their bodies take 5.55
actor1 = new Van at beside(place.lane.group.opposite.rightEdge, place.lane, ACTOR1_AT, -1.6),
    facing heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint 'vehicle.mercedes.sprinter'

## T: The run ends after 10 s.
terminate after 10 seconds
