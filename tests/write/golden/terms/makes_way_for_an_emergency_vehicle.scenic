## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=477, ego_lane='leftmost', oncoming=True,
    lanes=1, speed=20), speed=10))
EGO_AT = Range(77, 97)  # m along its lane

## E: Ego, a car, drives at 36 km/h; it drifts out of the lane to the right at a distance of 30 m, then stops.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until gap(self, actor1) < 30
    do Drive(line, EGO_SPEED, offset=-3.2, shift=0.7) for 3 seconds
    do Stop(line, rate=3.5, offset=self.beside)  # stops

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: An ambulance behind ego in the same lane, 60 m away, at 64.8 km/h; it overtakes ego.
ACTOR1_SPEED = 18  # m/s
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT - ACTOR1_GAP - 5.8  # m along the lane; their bodies take 5.8

behavior Actor1Behavior():
    line = route(place.lane)
    take SetSpeedAction(ACTOR1_SPEED)
    do Drive(line, ACTOR1_SPEED) until gap(self, ego) < 25.6
    do Drive(line, ACTOR1_SPEED, offset=3.5, shift=2) until lead_on(self, ego) > 10 + self.length
    do Drive(line, ACTOR1_SPEED)

actor1 = new Van at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint 'vehicle.ford.ambulance',
    with behavior Actor1Behavior()

## T: No restriction beyond the scene itself.
record gap(ego, actor1) as gap_ego_O1
terminate after 20 seconds
