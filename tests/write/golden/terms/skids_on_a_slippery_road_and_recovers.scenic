## G: A wet road, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = {'cloudiness': 5, 'precipitation': 0, 'precipitation_deposits': 50, 'wetness': 60,
    'wind_intensity': 10, 'fog_density': 0, 'sun_altitude_angle': 60}
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325), speed=13))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 46.8 km/h; it loses control for a moment.
EGO_SPEED = 13  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) for 3 seconds
    do Skid(line, 1.8, 4.5) for 1.2 seconds  # loses control for a moment
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## T: No restriction beyond the scene itself.
terminate after 20 seconds
