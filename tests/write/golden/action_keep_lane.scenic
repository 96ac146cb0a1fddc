## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=325, min_length=82), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
LEAD_SPEED = 12  # m/s
LEAD_GAP = 30  # m, bumper to bumper
LEAD_AT = EGO_AT + LEAD_GAP + 5  # m along the lane; their bodies take 5
lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), LEAD_SPEED)

## T
terminate after 20 seconds
