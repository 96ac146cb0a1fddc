## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the leftmost.
place = Uniform(*motorways(length=575, min_length=97, lanes=2, ego_lane='leftmost', speed=25))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 90 km/h.
EGO_SPEED = 25  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: 3 trucks ahead of ego in the lane to the right, 10 m away, 8 m apart, at 79.2 km/h.
PLATOON_SPEED = 22  # m/s
PLATOON_GAP = 10  # m, bumper to bumper
PLATOON_AT = EGO_AT + PLATOON_GAP + 6.55  # m along the lane; their bodies take 6.55

behavior PlatoonBehavior():
    line = route(place.right_lane)
    try:
        take SetSpeedAction(PLATOON_SPEED)
        do Drive(line, PLATOON_SPEED, rate=2.4)
    interrupt when braking_needed(self, platoon) > 3:  # m/s2
        do BrakeFor(line, [*platoon])

platoon = [new Truck at place.right_lane.centerline.pointAlongBy(PLATOON_AT + 15.9 * i),
    with blueprint Uniform(*TRUCKS),
    with behavior PlatoonBehavior() for i in range(3)]

## T: The run ends after 12 s.
terminate after 12 seconds
