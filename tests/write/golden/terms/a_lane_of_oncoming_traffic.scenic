## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=177, oncoming=True,
    lanes=1), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: 4 cars in the oncoming lane, 50 m away, 20 m apart, at 43.2 km/h.
ACTOR1_SPEED = 12  # m/s
ACTOR1_GAP = 50  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.oncoming_lane)
    try:
        take SetSpeedAction(ACTOR1_SPEED)
        do Drive(line, ACTOR1_SPEED)
    interrupt when braking_needed(self, actor1) > 3:  # m/s2
        do BrakeFor(line, [*actor1])

actor1 = [new Car at place.oncoming_lane.centerline.pointAlongBy(-(ACTOR1_AT + 24.8 * i)),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior() for i in range(4)]

## T: The run ends after 10 s.
terminate after 10 seconds
