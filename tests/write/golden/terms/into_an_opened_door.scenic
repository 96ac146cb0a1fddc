## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=111, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=6))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a bicycle, drives at 21.6 km/h; it hits the door.
EGO_SPEED = 6  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED, rate=2.4) until (distance from self to door) < leaves_for(self, line, door)
    do Ram(door, EGO_SPEED)

ego = new Bicycle at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.bh.crossbike',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car parked on the right, 60 m away.
PARKED_GAP = 60  # m, bumper to bumper
PARKED_AT = EGO_AT + PARKED_GAP + 3.5  # m along the lane; their bodies take 3.5
parked = new Car at beside(place.lane.rightEdge, place.lane, PARKED_AT, 1.6),
    facing heading_at(place.lane, PARKED_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS)

## O2: A barrier partly in the lane at its right edge, 62 m away.
DOOR_GAP = 62  # m, bumper to bumper
DOOR_AT = EGO_AT + DOOR_GAP + 1.75  # m along the lane; their bodies take 1.75
door = new Barrier at beside(place.lane.centerline, place.lane, DOOR_AT, 1.6),
    with regionContainedIn everywhere,
    facing heading_at(place.lane, DOOR_AT),
    with blueprint 'static.prop.streetbarrier'

## T: No restriction beyond the scene itself.
terminate after 20 seconds
