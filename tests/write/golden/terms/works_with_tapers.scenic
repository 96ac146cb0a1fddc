## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=425, min_length=172, lanes=2, ego_lane='rightmost', speed=17.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 57.6 km/h; it changes lane to the left.
EGO_SPEED = 16  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until braking_needed(self, works) > 2
    line = route(place.left_lane)
    do Drive(line, EGO_SPEED)  # changes lane to the left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A construction zone ahead of ego in the same lane, 110 m away.
WORKS_GAP = 110  # m, bumper to bumper
WORKS_AT = EGO_AT + WORKS_GAP + 8.6  # m along the lane; their bodies take 8.6
works_spot = new OrientedPoint at place.lane.centerline.pointAlongBy(WORKS_AT), facing roadDirection
works = [new Cone at works_spot offset by x @ y, with blueprint 'static.prop.constructioncone', with regionContainedIn everywhere
    for x, y in ((-1.4, -6), (-0.5, -4), (0.5, -2), (1.4, 0), (1.4, 4), (1.4, 8))]
works_barrier = new Barrier at works_spot offset by 0 @ 5, facing works_spot.heading + 90 deg,
    with blueprint 'static.prop.streetbarrier', with regionContainedIn everywhere
works_sign = new TrafficWarning at works_spot offset by 0.4 @ -9, facing works_spot.heading,
    with blueprint 'static.prop.trafficwarning', with rolename 'warning_sign',
    with regionContainedIn everywhere

## T: No restriction beyond the scene itself.
terminate after 20 seconds
