## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=101, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: 4 cars parked on the right, 30 m away, 2 m apart.
ROW_GAP = 30  # m, bumper to bumper
ROW_AT = EGO_AT + ROW_GAP + 5  # m along the lane; their bodies take 5
row = [new Car at beside(place.lane.rightEdge, place.lane, ROW_AT + 6.3 * i, 1.6),
    facing heading_at(place.lane, ROW_AT + 6.3 * i),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS) for i in range(4)]

## T: The run ends after 10 s.
terminate after 10 seconds
