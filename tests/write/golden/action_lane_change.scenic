## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*motorways(length=525, min_length=82, lanes=2, ego_lane='rightmost', speed=22.5))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
CHANGER_SPEED = 22  # m/s
CHANGER_GAP = 30  # m, bumper to bumper
CHANGER_AT = EGO_AT + CHANGER_GAP + 5  # m along the lane; their bodies take 5

behavior ChangerBehavior():
    line = route(place.lane)
    take SetSpeedAction(CHANGER_SPEED)
    do Drive(line, CHANGER_SPEED) for 3 seconds
    line = route(place.left_lane)
    do Drive(line, CHANGER_SPEED)  # changes lane to the left

changer = new Car at place.lane.centerline.pointAlongBy(CHANGER_AT),
    with blueprint Uniform(*CARS),
    with behavior ChangerBehavior()

## T
terminate after 20 seconds
