## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=108), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it swerves with 0.6 m to the actor1.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until braking_needed(self, actor1) > 2
    do Drive(line, 5.6, rate=4, offset=lambda: way_round(self, line, [actor1], room=0.6), shift=2.5) until lead_on(actor1, self) < -self.length
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A box ahead of ego in the same lane, 60 m away.
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 3  # m along the lane; their bodies take 3
actor1 = new Box at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint Uniform(*BOXES),
    with regionContainedIn everywhere,
    facing roadDirection

## T: No restriction beyond the scene itself.
terminate after 20 seconds
