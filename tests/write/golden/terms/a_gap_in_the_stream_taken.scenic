## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=580, lanes=2, ego_lane='rightmost', speed=25))
EGO_AT = Range(80, 100)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h; it changes lane to the left when the first has gone by ego.
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until passed(first, self, 0)
    line = route(place.left_lane)
    do Drive(line, EGO_SPEED)  # changes lane to the left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car behind ego in the lane to the left, 5 m away, at 90 km/h.
FIRST_SPEED = 25  # m/s
FIRST_GAP = 5  # m, bumper to bumper
FIRST_AT = EGO_AT - FIRST_GAP - 5  # m along the lane; their bodies take 5

behavior FirstBehavior():
    line = route(place.left_lane)
    try:
        take SetSpeedAction(FIRST_SPEED)
        do Drive(line, FIRST_SPEED)
    interrupt when braking_needed(self, ego) > 3:  # m/s2
        do BrakeFor(line, ego)

first = new Car at place.left_lane.centerline.pointAlongBy(FIRST_AT),
    with blueprint Uniform(*CARS),
    with behavior FirstBehavior()

## O2: A car behind the first in the same lane, 45 m away, at 90 km/h.
NEXT_SPEED = 25  # m/s
NEXT_GAP = 45  # m, bumper to bumper
NEXT_AT = FIRST_AT - NEXT_GAP - 5  # m along the lane; their bodies take 5

behavior NextBehavior():
    line = route(place.left_lane)
    try:
        take SetSpeedAction(NEXT_SPEED)
        do Drive(line, NEXT_SPEED)
    interrupt when braking_needed(self, [ego, first]) > 3:  # m/s2
        do BrakeFor(line, [ego, first])

next = new Car at place.left_lane.centerline.pointAlongBy(NEXT_AT),
    with blueprint Uniform(*CARS),
    with behavior NextBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
