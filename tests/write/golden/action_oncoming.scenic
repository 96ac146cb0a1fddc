## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=375, min_length=180, ego_lane='leftmost',
    oncoming=True), speed=10))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, intruder) > 2.5:  # m/s2
        do BrakeFor(line, intruder)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
INTRUDER_SPEED = 12  # m/s
INTRUDER_GAP = 127.6  # m, bumper to bumper
INTRUDER_AT = EGO_AT + INTRUDER_GAP + 5  # m along the lane; their bodies take 5

behavior IntruderBehavior():
    line = route(place.oncoming_lane)
    take SetSpeedAction(INTRUDER_SPEED)
    do Drive(line, INTRUDER_SPEED) until (distance from self to ego) < 61.6
    do Drive(line, INTRUDER_SPEED, offset=3.5, shift=2)  # gets into the opposite lane

intruder = new Car at place.oncoming_lane.centerline.pointAlongBy(-(INTRUDER_AT)),
    with blueprint Uniform(*CARS),
    with behavior IntruderBehavior()

## T
terminate after 20 seconds
