## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=724, lanes=2, ego_lane='rightmost', speed=30))
EGO_AT = Range(124, 144)  # m along its lane

## E: Ego, a car, drives at 72 km/h.
EGO_SPEED = 20  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: 5 cars behind ego in the lane to the left, 10 m away, 20 m apart, at 101 km/h.
STREAM_SPEED = 28  # m/s
STREAM_GAP = 10  # m, bumper to bumper
STREAM_AT = EGO_AT - STREAM_GAP - 5  # m along the lane; their bodies take 5

behavior StreamBehavior():
    line = route(place.left_lane)
    try:
        take SetSpeedAction(STREAM_SPEED)
        do Drive(line, STREAM_SPEED)
    interrupt when braking_needed(self, stream) > 3:  # m/s2
        do BrakeFor(line, [*stream])

stream = [new Car at place.left_lane.centerline.pointAlongBy(STREAM_AT - 24.8 * i),
    with blueprint Uniform(*CARS),
    with behavior StreamBehavior() for i in range(5)]

## T: The run ends after 12 s.
terminate after 12 seconds
