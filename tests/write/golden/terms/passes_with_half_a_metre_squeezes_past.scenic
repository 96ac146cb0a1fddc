## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=94, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it keeps the lane with 0.5 m to the actor1.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED, offset=lambda: leaving_room(self, line, actor1, 0.5))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A van parked on the right, 40 m away.
ACTOR1_GAP = 40  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5.55  # m along the lane; their bodies take 5.55
actor1 = new Van at beside(place.lane.rightEdge, place.lane, ACTOR1_AT, 1.6),
    facing heading_at(place.lane, ACTOR1_AT),
    with regionContainedIn everywhere,
    with blueprint 'vehicle.mercedes.sprinter'

## T: No restriction beyond the scene itself.
terminate after 20 seconds
