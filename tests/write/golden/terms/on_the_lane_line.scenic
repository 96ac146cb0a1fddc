## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=375, min_length=70, lanes=2, ego_lane='rightmost', speed=15))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 54 km/h.
EGO_SPEED = 15  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A motorcycle partly in the lane at its left edge, 20 m away, at 43.2 km/h.
ACTOR1_SPEED = 12  # m/s
ACTOR1_GAP = 20  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3.7  # m along the lane; their bodies take 3.7

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED, offset=1.6)

actor1 = new Motorcycle at beside(place.lane.centerline, place.lane, ACTOR1_AT, -1.6),
    with regionContainedIn everywhere,
    facing heading_at(place.lane, ACTOR1_AT),
    with blueprint Uniform(*MOTORCYCLES),
    with behavior Actor1Behavior()

## T: The run ends after 12 s.
terminate after 12 seconds
