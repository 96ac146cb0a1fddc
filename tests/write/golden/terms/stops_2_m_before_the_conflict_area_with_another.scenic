## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection without lights or signs, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='none', approach=60,
    others=[From('left')]), speed=8))
EGO_TO_JUNCTION = 35  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 28.8 km/h; it stops with 2 m to the actor1.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do StopBefore(line, [actor1], room=2, rate=3.5)  # stops
    do Stop(line, rate=3.5)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1: A car on the road that crosses from the left; it goes straight on.
ACTOR1_SPEED = 11  # m/s
ACTOR1_TO_JUNCTION = 54.12  # m
actor1 = new Car at place.from_left.centerline.pointAlongBy(-ACTOR1_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.from_left), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
