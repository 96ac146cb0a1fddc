## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the leftmost.
place = Uniform(*motorways(length=425, lanes=2, ego_lane='leftmost', speed=20))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 72 km/h; it leaves the road to the left.
EGO_SPEED = 20  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do Drive(line, EGO_SPEED, offset=place.lane.group.leftEdge.distanceTo(self.position) + 4, shift=2)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
