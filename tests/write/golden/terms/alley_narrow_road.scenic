## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=116), speed=6.95))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives slowly.
EGO_SPEED = Range(5.6, 8.3)  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: 3 walls partly in the lane at its left edge, 30 m away, 1 m apart.
LEFT_WALL_GAP = 30  # m, bumper to bumper
LEFT_WALL_AT = EGO_AT + LEFT_WALL_GAP + 8.6  # m along the lane; their bodies take 8.6
left_wall = [new Barrier at beside(place.lane.centerline, place.lane, LEFT_WALL_AT + 13 * i, -1.6),
    with regionContainedIn everywhere,
    facing heading_at(place.lane, LEFT_WALL_AT + 13 * i),
    with blueprint 'static.prop.streetbarrier',
    with rolename 'wall',
    with length 12,
    with width 0.4,
    with height 2.2 for i in range(3)]

## O2: 3 walls partly in the lane at its right edge, 30 m away, 1 m apart.
RIGHT_WALL_GAP = 30  # m, bumper to bumper
RIGHT_WALL_AT = EGO_AT + RIGHT_WALL_GAP + 8.6  # m along the lane; their bodies take 8.6
right_wall = [new Barrier at beside(place.lane.centerline, place.lane, RIGHT_WALL_AT + 13 * i, 1.6),
    with regionContainedIn everywhere,
    facing heading_at(place.lane, RIGHT_WALL_AT + 13 * i),
    with blueprint 'static.prop.streetbarrier',
    with rolename 'wall',
    with length 12,
    with width 0.4,
    with height 2.2 for i in range(3)]

## T: The run ends after 14 s.
record gap(ego, left_wall[0]) as gap_ego_O1
record gap(ego, right_wall[0]) as gap_ego_O2
terminate after 14 seconds
