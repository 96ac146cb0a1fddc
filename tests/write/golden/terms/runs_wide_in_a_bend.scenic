## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A curve to the right, with an oncoming lane beside.
place = Uniform(*ordinary(curves('right', length=275, ego_lane='leftmost', oncoming=True,
    lanes=1), speed=12))
EGO_TO_BEND = 40  # m
EGO_AT = max(25, place.mark - EGO_TO_BEND)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it drifts out of the lane to the left when it is at the bend.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until along(place.lane, self.position) + self.length / 2 > place.mark
    do Drive(line, EGO_SPEED, offset=3.2, shift=0.7)  # drifts out of the lane to the left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
