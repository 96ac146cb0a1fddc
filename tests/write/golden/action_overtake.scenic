## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*motorways(length=635, lanes=2, ego_lane='rightmost', speed=30))
EGO_AT = Range(35, 55)  # m along its lane

## E
EGO_SPEED = 20  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
PASSER_SPEED = 28  # m/s
PASSER_GAP = 20  # m, bumper to bumper
PASSER_AT = EGO_AT - PASSER_GAP - 5  # m along the lane; their bodies take 5

behavior PasserBehavior():
    line = route(place.lane)
    take SetSpeedAction(PASSER_SPEED)
    do Drive(line, PASSER_SPEED) until gap(self, ego) < 25.6
    line = route(place.left_lane)
    do Drive(line, PASSER_SPEED) until lead_on(self, ego) > 10 + self.length
    line = route(place.lane)
    do Drive(line, PASSER_SPEED)

passer = new Car at place.lane.centerline.pointAlongBy(PASSER_AT),
    with blueprint Uniform(*CARS),
    with behavior PasserBehavior()

## T
terminate after 20 seconds
