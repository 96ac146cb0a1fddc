## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=325, min_length=82, speed=15), speed=14))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
LEAD_SPEED = 14  # m/s
LEAD_GAP = 30  # m, bumper to bumper
LEAD_AT = EGO_AT + LEAD_GAP + 5  # m along the lane; their bodies take 5

behavior LeadBehavior():
    line = route(place.lane)
    take SetSpeedAction(LEAD_SPEED)
    do Drive(line, LEAD_SPEED) for 3 seconds
    do Drive(line, LEAD_SPEED, offset=2.2, shift=2.5) for 2.5 seconds
    do Drive(line, LEAD_SPEED)

lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior LeadBehavior()

## T
terminate after 20 seconds
