## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=112, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it keeps the lane with 0.8 m to the door.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED, offset=lambda: leaving_room(self, line, door, 0.8))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car parked on the right, 60 m away.
PARKED_GAP = 60  # m, bumper to bumper
PARKED_AT = EGO_AT + PARKED_GAP + 5  # m along the lane; their bodies take 5
parked = new Car at beside(place.lane.rightEdge, place.lane, PARKED_AT, 1.6),
    facing heading_at(place.lane, PARKED_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS)

## O2: A barrier partly in the lane at its right edge, 62 m away.
DOOR_GAP = 62  # m, bumper to bumper
DOOR_AT = EGO_AT + DOOR_GAP + 3.25  # m along the lane; their bodies take 3.25
door = new Barrier at beside(place.lane.centerline, place.lane, DOOR_AT, 1.6),
    with regionContainedIn everywhere,
    facing heading_at(place.lane, DOOR_AT),
    with blueprint 'static.prop.streetbarrier'

## T: No restriction beyond the scene itself.
terminate after 20 seconds
