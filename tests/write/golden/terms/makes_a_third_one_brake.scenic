## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 3 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=575, min_length=82, lanes=3, ego_lane='rightmost', speed=27.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 79.2 km/h.
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the same lane, 30 m away, at 79.2 km/h; it changes lane to the left.
CUTTER_SPEED = 22  # m/s
CUTTER_GAP = 30  # m, bumper to bumper
CUTTER_AT = EGO_AT + CUTTER_GAP + 5  # m along the lane; their bodies take 5

behavior CutterBehavior():
    line = route(place.lane)
    take SetSpeedAction(CUTTER_SPEED)
    do Drive(line, CUTTER_SPEED) for 3 seconds
    line = route(place.left_lane)
    do Drive(line, CUTTER_SPEED)  # changes lane to the left

cutter = new Car at place.lane.centerline.pointAlongBy(CUTTER_AT),
    with blueprint Uniform(*CARS),
    with behavior CutterBehavior()

## O2: A car ahead of ego in the lane to the left, 5 m away, at 93.6 km/h; it brakes.
OTHER_SPEED = 26  # m/s
OTHER_GAP = 5  # m, bumper to bumper
OTHER_AT = EGO_AT + OTHER_GAP + 5  # m along the lane; their bodies take 5

behavior OtherBehavior():
    line = route(place.left_lane)
    take SetSpeedAction(OTHER_SPEED)
    do Drive(line, OTHER_SPEED) until off_lane(cutter)
    do Drive(line, 20, rate=3)  # brakes

other = new Car at place.left_lane.centerline.pointAlongBy(OTHER_AT),
    with blueprint Uniform(*CARS),
    with behavior OtherBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
