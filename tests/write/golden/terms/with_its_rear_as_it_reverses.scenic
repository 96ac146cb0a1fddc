## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*stretches(straight=True, length=195))
EGO_AT = Range(45, 65)  # m along its lane

## E: Ego, a car, stands at first; it reverses, then hits the actor1 with its rear at the front of the actor1.
EGO_SPEED = 0  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    do BackInto(actor1, 2) until touch(self, actor1)
    take SetReverseAction(False)
    do Drive(line, 2) until touch(self, actor1)
    do Drive(line, 0, rate=6)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()

## O1: A car behind ego in the same lane, 8 m away; it stands still.
ACTOR1_AT = EGO_AT - 8 - 5  # m along the lane
actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
