## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*stretches(length=375, least=102, ego_lane='rightmost', shoulder=True, speed=15))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, puller) > 2.5:
        do BrakeFor(line, puller)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()

## O1
PULLER_AT = EGO_AT + 50 + 5  # m along the lane

behavior PullerBehavior():
    line = way(place.lane)
    do Drive(line, 0) until pulls_out(self, ego, line, 2.4, -1.69)
    do Drive(line, 7, rate=2.4)

puller = new Car at beside(place.lane.rightEdge, place.lane, PULLER_AT, 1.6),
    facing heading_at(place.lane, PULLER_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS),
    with behavior PullerBehavior()

## T
terminate after 20 seconds
