## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*motorways(length=525, least=47, lanes=2, ego_lane='rightmost'))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, cutter) > 2.5:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, cutter)))) until need(self, cutter) <= 0

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
CUTTER_SPEED = 24  # m/s
CUTTER_AT = EGO_AT

behavior CutterBehavior():
    line = way(place.left_lane)
    take SetSpeedAction(CUTTER_SPEED)
    do Drive(line, 26) until 5 < lead_on(self, ego) - self.length < 25
    line = way(place.lane)
    do Drive(line, CUTTER_SPEED) for 2.5 seconds
    do Drive(line, 16.5, rate=3) for 3 seconds
    do Drive(line, CUTTER_SPEED)

cutter = new Car at place.left_lane.centerline.pointAlongBy(CUTTER_AT),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior CutterBehavior()

## T
require monitor OnceSeen([
    lambda: place.lane.centerline.distanceTo(cutter.position) < 1.7,
])
terminate after 20 seconds
