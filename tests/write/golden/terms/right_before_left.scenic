## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection without lights or signs, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='none', approach=61,
    others=[From('right')]), speed=9))
EGO_TO_JUNCTION = 36  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 32.4 km/h; it gives way to the actor1.
EGO_SPEED = 9  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do Drive(line, lambda: up_to(to_line(self, place.lane), EGO_SPEED), rate=5) until passed(actor1, self)
    do Drive(line, EGO_SPEED, rate=2)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1: A car on the road that crosses from the right; it goes straight on.
ACTOR1_SPEED = 11  # m/s
ACTOR1_AHEAD = Range(-0.3, 0.3)  # s before ego where their ways cross, if neither reacts
ACTOR1_TO_JUNCTION = start_to_meet(
    place.from_right, route(place.from_right), ACTOR1_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=ACTOR1_AHEAD)  # m
actor1 = new Car at place.from_right.centerline.pointAlongBy(-ACTOR1_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.from_right), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
