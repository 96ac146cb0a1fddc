## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=114, ego_lane='leftmost',
    oncoming=True, lanes=1), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it overtakes the actor1.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until (distance from self to actor1) < 12 + 1.9 * self.speed
    do Drive(line, EGO_SPEED, offset=3.5, shift=2) until lead_on(self, actor1) > 10 + self.length
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A van ahead of ego in the same lane, 60 m away; it stands still.
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 5.55  # m along the lane; their bodies take 5.55
actor1 = new Van at place.lane.centerline.pointAlongBy(ACTOR1_AT),
    with blueprint 'vehicle.mercedes.sprinter'

## T: No restriction beyond the scene itself.
terminate after 20 seconds
