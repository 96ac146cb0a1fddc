## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=130,
    ego_lane='rightmost'), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes at a distance of 20 m.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until gap(self, actor1) < 20
    do Drive(line, 8, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A speed sign at the right roadside, 80 m away.
ACTOR1_GAP = 80  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3.8  # m along the lane; their bodies take 3.8
actor1 = new TrafficWarning at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 2.4),
    facing heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint 'static.prop.trafficwarning',
    with rolename 'speed_sign:30'

## T: No restriction beyond the scene itself.
terminate after 20 seconds
