## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=66, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=1.95))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at walking pace.
EGO_SPEED = Range(1.1, 2.8)  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: 4 cars parked on the right, 5 m away, 2 m apart.
ROW_GAP = 5  # m, bumper to bumper
ROW_AT = EGO_AT + ROW_GAP + 3.7  # m along the lane; their bodies take 3.7
row = [new Car at beside(place.lane.rightEdge, place.lane, ROW_AT + 3.7 * i, 3.6),
    facing 90 deg relative to heading_at(place.lane, ROW_AT + 3.7 * i),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS) for i in range(4)]

## T: The run ends after 12 s.
terminate after 12 seconds
