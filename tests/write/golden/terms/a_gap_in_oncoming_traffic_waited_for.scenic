## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection without lights or signs, where ego turns left.
place = Uniform(*ordinary(junctions(LEFT_TURN, control='none', approach=120,
    others=[From('opposite', length=131)]), speed=8))
EGO_TO_JUNCTION = 35  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 28.8 km/h; it gives way to the first, then turns left when the first has gone by ego.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
    do Drive(line, lambda: up_to(to_line(self, place.lane), EGO_SPEED), rate=5) until passed(first, self, 0)
    do Drive(line, EGO_SPEED)  # turns left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1: A car on the opposite approach of the intersection; it goes straight on.
FIRST_SPEED = 11  # m/s
FIRST_AHEAD = Range(-0.3, 0.3)  # s before ego where their ways cross, if neither reacts
FIRST_TO_JUNCTION = start_to_meet(
    place.from_opposite, route(place.from_opposite), FIRST_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=FIRST_AHEAD)  # m
first = new Car at place.from_opposite.centerline.pointAlongBy(-FIRST_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.from_opposite), FIRST_SPEED)

## O2: A car behind the first in the same lane, 70 m away; it goes straight on.
NEXT_SPEED = 11  # m/s
NEXT_TO_JUNCTION = FIRST_TO_JUNCTION + 70 + 4.8  # m

behavior NextBehavior():
    line = route(place.from_opposite)
    try:
        take SetSpeedAction(NEXT_SPEED)
        do Drive(line, NEXT_SPEED)
    interrupt when braking_needed(self, first) > 3:  # m/s2
        do BrakeFor(line, first)

next = new Car at place.from_opposite.centerline.pointAlongBy(-(NEXT_TO_JUNCTION)),
    with blueprint Uniform(*CARS),
    with behavior NextBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
