## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=108, ego_lane='rightmost',
    speed=15), speed=14))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 50.4 km/h; it leaves the road to the right, then hits the actor1.
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until (distance from self to actor1) < leaves_for(self, line, actor1)
    do Ram(actor1, EGO_SPEED) until touch(self, actor1)
    do Drive(line, EGO_SPEED) until touch(self, actor1)  # hits the actor1
    do Stop(line, rate=6)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A tree at the right roadside, 60 m away.
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3  # m along the lane; their bodies take 3
actor1 = new PlantPot at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 2.4),
    facing heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint 'static.prop.plantpot01',
    with rolename 'tree',
    with length 0.8,
    with width 0.8,
    with height 8

## T: No restriction beyond the scene itself.
terminate after 20 seconds
