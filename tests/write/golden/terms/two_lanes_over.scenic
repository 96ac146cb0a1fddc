## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 3 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=685, lanes=3, ego_lane='rightmost', speed=32.5))
EGO_AT = Range(35, 55)  # m along its lane

## E: Ego, a car, drives at 90 km/h.
EGO_SPEED = 25  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car behind ego in the lane to the left, 20 m away, 2 lanes over, at 115 km/h.
FAST_SPEED = 32  # m/s
FAST_GAP = 20  # m, bumper to bumper
FAST_AT = EGO_AT - FAST_GAP - 5  # m along the lane; their bodies take 5
fast = new Car at place.far_left_lane.centerline.pointAlongBy(FAST_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.far_left_lane), FAST_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
