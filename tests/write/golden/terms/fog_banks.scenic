## G: Fog, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = {'cloudiness': 60, 'precipitation': 0, 'precipitation_deposits': 0, 'wetness': 0,
    'wind_intensity': 10, 'fog_density': 60, 'fog_distance': 10, 'sun_altitude_angle': 60}
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, speed=15), speed=14))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 50.4 km/h; it brakes.
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do Drive(line, 8, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
