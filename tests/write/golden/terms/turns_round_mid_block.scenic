## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=112, oncoming=True,
    lanes=1), speed=8))
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

## O1: A car in the oncoming lane, 60 m away, at 21.6 km/h; it turns round.
ACTOR1_SPEED = 6  # m/s
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.oncoming_lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) until (distance from self to ego) < 42.8
    do TurnRound()  # turns round
    do Drive(line, 8)

actor1 = new Car at place.oncoming_lane.centerline.pointAlongBy(-(ACTOR1_AT)),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
