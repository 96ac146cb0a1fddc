## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road, with an oncoming lane beside.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=116, oncoming=True,
    lanes=1)))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, stands at first; it stands still until the actor1 has gone by ego.
EGO_SPEED = 0  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    do Stop(line, rate=4) until passed(actor1, self, 0)  # stands still
    do Drive(line, 8)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A truck in the oncoming lane, 60 m away, at 43.2 km/h.
ACTOR1_SPEED = 12  # m/s
ACTOR1_GAP = 60  # m, bumper to bumper
ACTOR1_AT = EGO_AT + ACTOR1_GAP + 6.55  # m along the lane; their bodies take 6.55
actor1 = new Truck at place.oncoming_lane.centerline.pointAlongBy(-(ACTOR1_AT)),
    with blueprint Uniform(*TRUCKS),
    with behavior Cruise(route(place.oncoming_lane), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
