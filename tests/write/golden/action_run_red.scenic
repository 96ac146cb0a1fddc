## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(junctions(STRAIGHT, control='signal', approach=69,
    others=[From('left')]), speed=11))
EGO_TO_JUNCTION = 44  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, runner) > 2.5:  # m/s2
        do BrakeFor(line, runner)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1
RUNNER_SPEED = 11  # m/s
RUNNER_AHEAD = Range(-0.3, 0.3)  # s before ego where their ways cross, if neither reacts
RUNNER_TO_JUNCTION = start_to_meet(
    place.from_left, route(place.from_left), RUNNER_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=RUNNER_AHEAD)  # m
runner = new Car at place.from_left.centerline.pointAlongBy(-RUNNER_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with light 'red',
    with behavior Cruise(route(place.from_left), RUNNER_SPEED)

## T
terminate after 20 seconds
