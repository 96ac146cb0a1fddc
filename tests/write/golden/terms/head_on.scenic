## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=132, ego_lane='leftmost',
    oncoming=True, lanes=1), speed=10))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 36 km/h.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car in the oncoming lane, 80 m away, at 43.2 km/h; it hits ego with its front at the front of ego.
ACTOR1_SPEED = 12  # m/s
ACTOR1_GAP = 80  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.oncoming_lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED, offset=3.5, shift=2) until touch(self, ego)  # hits ego
    do Stop(line, rate=6)

actor1 = new Car at place.oncoming_lane.centerline.pointAlongBy(-(ACTOR1_AT)),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
