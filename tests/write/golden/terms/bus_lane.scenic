## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, 2 or more lanes in ego's direction, ego in the leftmost.
place = Uniform(*stretches(straight=True, length=275, min_length=68, lanes=2, ego_lane='leftmost'))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 36 km/h.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A bus ahead of ego in the lane to the right, 10 m away, at 25.2 km/h.
ACTOR1_SPEED = 7  # m/s
ACTOR1_GAP = 10  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 7.75  # m along the lane; their bodies take 7.75
actor1 = new Bus at place.right_lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint 'vehicle.mitsubishi.fusorosa',
    with regionContainedIn everywhere,
    with behavior Cruise(route(place.right_lane), ACTOR1_SPEED)

## T: The run ends after 10 s.
terminate after 10 seconds
