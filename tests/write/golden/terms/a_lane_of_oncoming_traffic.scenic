## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*stretches(straight=True, length=325, least=177, oncoming=True, lanes=1))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()

## O1: 4 cars in the oncoming lane, 50 m away, at 43.2 km/h.
ACTOR1_SPEED = 12  # m/s
ACTOR1_AT = EGO_AT + 50 + 5  # m along the lane

behavior Actor1Behavior():
    line = way(place.oncoming_lane)
    try:
        take SetSpeedAction(ACTOR1_SPEED)
        do Drive(line, ACTOR1_SPEED)
    interrupt when most_need(self, [*actor1]) > 3:
        do BrakeFor(line, [*actor1])

actor1 = [new Car at place.oncoming_lane.centerline.pointAlongBy(-(ACTOR1_AT + 24.8 * i)),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior() for i in range(4)]

## T: The run ends after 10 s.
terminate after 10 seconds
