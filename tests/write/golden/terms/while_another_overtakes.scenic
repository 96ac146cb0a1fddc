## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=380, ego_lane='leftmost', oncoming=True,
    lanes=1, speed=17.5), speed=10))
EGO_AT = Range(30, 50)  # m along its lane

## E: Ego, a car, drives at 36 km/h; it accelerates.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until lead_on(actor1, ego) > -5
    do Drive(line, 13, rate=2.5)  # accelerates

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car behind ego in the same lane, 15 m away, at 57.6 km/h; it overtakes ego.
ACTOR1_SPEED = 16  # m/s
ACTOR1_GAP = 15  # m, bumper to bumper
ACTOR1_AT = EGO_AT - ACTOR1_GAP - 5  # m along the lane; their bodies take 5

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) until gap(self, ego) < 21.2
    do Drive(line, ACTOR1_SPEED, offset=3.5, shift=2) until lead_on(self, ego) > 10 + self.length
    do Drive(line, ACTOR1_SPEED)

actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS),
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
