## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction.
place = Uniform(*motorways(length=675, min_length=102, lanes=2, ego_lane='rightmost', speed=32.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 90 km/h; it changes lane to the left when the lead is as far as 25 m from the fast.
EGO_SPEED = 25  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until gap(lead, fast) > 25
    line = route(place.left_lane)
    do Drive(line, EGO_SPEED)  # changes lane to the left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the same lane, 50 m away, at 90 km/h.
LEAD_SPEED = 25  # m/s
LEAD_GAP = 50  # m, bumper to bumper
LEAD_AT = EGO_AT + LEAD_GAP + 5  # m along the lane; their bodies take 5
lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), LEAD_SPEED)

## O2: A car ahead of ego in the lane to the left, 40 m away, at 112 km/h.
FAST_SPEED = 31  # m/s
FAST_GAP = 40  # m, bumper to bumper
FAST_AT = EGO_AT + FAST_GAP + 5  # m along the lane; their bodies take 5
fast = new Car at place.left_lane.centerline.pointAlongBy(FAST_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.left_lane), FAST_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
