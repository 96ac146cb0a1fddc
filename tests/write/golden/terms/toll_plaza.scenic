## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction.
place = Uniform(*motorways(length=325, min_length=161, lanes=2, ego_lane='rightmost'))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes at walking pace at a distance of 25 m.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until gap(self, booth) < 25
    do Drive(line, 1.95, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A toll booth at the right roadside, 110 m away.
BOOTH_GAP = 110  # m, bumper to bumper
BOOTH_AT = EGO_AT + BOOTH_GAP + 4.1  # m along the lane; their bodies take 4.1
booth = new Kiosk at beside(place.lane.rightEdge, place.lane, BOOTH_AT, 2.4),
    facing heading_at(place.lane, BOOTH_AT),
    with regionContainedIn everywhere,
    with blueprint 'static.prop.kiosk_01',
    with rolename 'toll_booth',
    with length 3,
    with width 2,
    with height 2.8

## T: No restriction beyond the scene itself.
terminate after 20 seconds
