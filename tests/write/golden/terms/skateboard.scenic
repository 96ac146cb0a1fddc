## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=98,
    ego_lane='rightmost'), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A pedestrian on the right sidewalk, 50 m away; it moves along the road at a jog.
SKATEBOARD_SPEED = Range(2.2, 3)  # m/s
SKATEBOARD_GAP = 50  # m, bumper to bumper
SKATEBOARD_AT = EGO_AT + SKATEBOARD_GAP + 2.85  # m along the lane; their bodies take 2.85

behavior SkateboardBehavior():
    do Walk(self.heading, SKATEBOARD_SPEED)

skateboard = new Pedestrian at beside(place.lane.rightEdge, place.lane, SKATEBOARD_AT, 3),
    facing heading_at(place.lane, SKATEBOARD_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*PEDESTRIANS),
    with behavior SkateboardBehavior()

## T: The run ends after 8 s.
terminate after 8 seconds
