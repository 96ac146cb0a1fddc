## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the leftmost.
place = Uniform(*motorways(length=337, min_length=194, lanes=2, ego_lane='leftmost'))
EGO_AT = Range(37, 57)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it changes lane to the right when the first has gone by ego.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until passed(first, self, 0)
    line = route(place.right_lane)
    do Drive(line, EGO_SPEED)  # changes lane to the right

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A car abreast of ego in the lane to the right, at 36 km/h.
FIRST_SPEED = 10  # m/s
FIRST_AT = EGO_AT
first = new Car at place.right_lane.centerline.pointAlongBy(FIRST_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.right_lane), FIRST_SPEED)

## O2: A car behind the first in the same lane, 22 m away, at 36 km/h.
SECOND_SPEED = 10  # m/s
SECOND_GAP = 22  # m, bumper to bumper
SECOND_AT = FIRST_AT - SECOND_GAP - 5  # m along the lane; their bodies take 5

behavior SecondBehavior():
    line = route(place.right_lane)
    try:
        take SetSpeedAction(SECOND_SPEED)
        do Drive(line, SECOND_SPEED)
    interrupt when braking_needed(self, [ego, first]) > 3:  # m/s2
        do BrakeFor(line, [ego, first])

second = new Car at place.right_lane.centerline.pointAlongBy(SECOND_AT),
    with blueprint Uniform(*CARS),
    with behavior SecondBehavior()

## O3: A lane closure ahead of ego in the same lane, 120 m away.
WORKS_GAP = 120  # m, bumper to bumper
WORKS_AT = EGO_AT + WORKS_GAP + 8.6  # m along the lane; their bodies take 8.6
works_spot = new OrientedPoint at place.lane.centerline.pointAlongBy(WORKS_AT), facing roadDirection
works = [new Cone at works_spot offset by x @ y, with blueprint 'static.prop.trafficcone01', with regionContainedIn everywhere
    for x, y in ((-1.4, -6), (-0.5, -4), (0.5, -2), (1.4, 0), (1.4, 4), (1.4, 8))]
works_barrier = new Barrier at works_spot offset by 0 @ 5, facing works_spot.heading + 90 deg,
    with blueprint 'static.prop.streetbarrier', with regionContainedIn everywhere

## T: No restriction beyond the scene itself.
terminate after 20 seconds
