## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*stretches(length=375, least=102, ego_lane='rightmost', shoulder=True))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, puller) > 2.5:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, puller)))) until need(self, puller) <= 0

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
PULLER_AT = EGO_AT + 50 + 5  # m along the lane

behavior PullerBehavior():
    line = way(place.lane)
    line = way(place.lane)
    do Drive(line, 7, rate=3)

puller = new Car at (new OrientedPoint at place.lane.rightEdge.project(place.lane.centerline.pointAlongBy(PULLER_AT)), facing roadDirection at place.lane.centerline.pointAlongBy(PULLER_AT)) offset by 1.4 @ 0,
    facing (roadDirection at place.lane.centerline.pointAlongBy(PULLER_AT)),
    with regionContainedIn everywhere,
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior PullerBehavior()

## T
terminate after 20 seconds
