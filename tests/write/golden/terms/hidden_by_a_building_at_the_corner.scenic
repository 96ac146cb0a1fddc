## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection without lights or signs, where ego goes straight on.
place = Uniform(*ordinary(junctions(STRAIGHT, control='none', approach=69, ego_lane='rightmost',
    others=[From('right')]), speed=11))
EGO_TO_JUNCTION = 44  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 39.6 km/h; it brakes for what comes into its way.
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, in_view(self, [crosser], [house])) > 2.5:  # m/s2
        do BrakeFor(line, lambda: [*in_view(self, [crosser], [house])])

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1: A building at the right roadside.
HOUSE_LENGTH = max(14, EGO_TO_JUNCTION - 3)  # m
HOUSE_AT = place.length - 3 - HOUSE_LENGTH / 2  # m along the lane
house = new Container at beside(place.lane.rightEdge, place.lane, HOUSE_AT, 7.5),
    facing heading_at(place.lane, HOUSE_AT),
    with regionContainedIn everywhere,
    with length HOUSE_LENGTH,
    with blueprint 'static.prop.container',
    with rolename 'building',
    with width 10,
    with height 8

## O2: A car on the road that crosses from the right, hidden by the house, at 32.4 km/h; it goes straight on.
CROSSER_SPEED = 9  # m/s
CROSSER_AHEAD = Range(-0.3, 0.3)  # s before ego where their ways cross, if neither reacts
CROSSER_TO_JUNCTION = start_to_meet(
    place.from_right, route(place.from_right), CROSSER_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=CROSSER_AHEAD)  # m
crosser = new Car at place.from_right.centerline.pointAlongBy(-CROSSER_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.from_right), CROSSER_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
