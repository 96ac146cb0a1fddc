## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=141), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 25 m away, at 43.2 km/h; it loses control for a moment at a distance of 1 m.
THE_CAR_SPEED = 12  # m/s
THE_CAR_GAP = 25  # m, bumper to bumper
THE_CAR_AT = EGO_AT + THE_CAR_GAP + 5  # m along the lane; their bodies take 5

behavior TheCarBehavior():
    line = route(place.lane)
    take SetSpeedAction(THE_CAR_SPEED)
    do Drive(line, THE_CAR_SPEED) until gap(self, ice) < 1
    do Skid(line, 1.8, 6) for 1.2 seconds  # loses control for a moment
    do Drive(line, THE_CAR_SPEED)

the_car = new Car at place.lane.centerline.pointAlongBy(THE_CAR_AT),
    with blueprint Uniform(*CARS),
    with behavior TheCarBehavior()

## O2: A slippery patch ahead of ego in the same lane, 90 m away.
ICE_GAP = 90  # m, bumper to bumper
ICE_AT = EGO_AT + ICE_GAP + 4.45  # m along the lane; their bodies take 4.45
ice = new Debris at place.lane.centerline.pointAlongBy(ICE_AT),
    with blueprint 'static.prop.dirtdebris01',
    with rolename 'slippery_patch',
    with regionContainedIn everywhere,
    facing roadDirection,
    with length 3.7,
    with width 1.8,
    with height 0.1

## T: No restriction beyond the scene itself.
terminate after 20 seconds
