## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=575, min_length=102, lanes=2, ego_lane='rightmost', speed=25))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 90 km/h; it follows the actor1.
EGO_SPEED = 25  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: following_speed(self, actor1, EGO_SPEED), rate=4)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car ahead of ego in the same lane, 50 m away, at 68.4 km/h.
ACTOR1_SPEED = 19  # m/s
ACTOR1_GAP = 50  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5
actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), ACTOR1_SPEED)

## T: The run ends after 12 s.
terminate after 12 seconds
