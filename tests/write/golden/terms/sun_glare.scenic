## G: Clear weather, dusk.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = {'cloudiness': 5, 'precipitation': 0, 'precipitation_deposits': 0, 'wetness': 0,
    'wind_intensity': 10, 'fog_density': 0, 'sun_altitude_angle': 4}
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=112), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes hard at a distance of 10 m, then hits the actor1.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until gap(self, actor1) < 10
    do SlowTo(line, EGO_SPEED / 2, rate=6)  # brakes
    do Drive(line, 6) until touch(self, actor1)  # hits the actor1
    do Stop(line, rate=6)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 60 m away; it stands still.
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5  # m along the lane; their bodies take 5
actor1 = new Car at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*CARS)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
