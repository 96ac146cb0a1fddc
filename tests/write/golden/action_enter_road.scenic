## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=375, min_length=102, ego_lane='rightmost', shoulder=True,
    speed=15), speed=13.9))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, puller) > 2.5:  # m/s2
        do BrakeFor(line, puller)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
PULLER_GAP = 50  # m, bumper to bumper
PULLER_AT = EGO_AT + PULLER_GAP + 5  # m along the lane; their bodies take 5

behavior PullerBehavior():
    line = route(place.lane)
    do Stop(line) until pulls_out(self, ego, line, 2.4, -1.69)
    do Drive(line, 7, rate=2.4)  # comes onto the road

puller = new Car at beside(place.lane.rightEdge, place.lane, PULLER_AT, 1.6),
    facing heading_at(place.lane, PULLER_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS),
    with behavior PullerBehavior()

## T
terminate after 20 seconds
