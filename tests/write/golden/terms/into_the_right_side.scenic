## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection without lights or signs, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='none', approach=61,
    others=[From('left')]), speed=9))
EGO_TO_JUNCTION = 36  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h; it hits the actor1 with its front at the right of the actor1.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until touch(self, actor1)  # hits the actor1
    do Stop(line, rate=6)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1: A car on the road that crosses from the left, at 25.2 km/h; it goes straight on.
ACTOR1_SPEED = 7  # m/s
ACTOR1_AHEAD = Range(-0.05, 0.05)  # s before ego where their ways cross, if neither reacts
ACTOR1_TO_JUNCTION = start_to_meet(
    place.from_left, route(place.from_left), ACTOR1_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=ACTOR1_AHEAD,
    strikes=Part('right', 4.8, 2.2), struck=Part('front', 4.8, 2.2))  # m
actor1 = new Car at place.from_left.centerline.pointAlongBy(-ACTOR1_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.from_left), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
