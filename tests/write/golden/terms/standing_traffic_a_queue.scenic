## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=136), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it stops with 3 m to the queue.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do StopBefore(line, [*queue], room=3, rate=3.5)  # stops
    do Stop(line, rate=3.5)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: 4 cars ahead of ego in the same lane, 60 m away, 3 m apart; they stand still.
QUEUE_GAP = 60  # m, bumper to bumper
QUEUE_AT = EGO_AT + QUEUE_GAP + 5  # m along the lane; their bodies take 5
queue = [new Car at place.lane.centerline.pointAlongBy(QUEUE_AT + 7.8 * i),
    with blueprint Uniform(*CARS) for i in range(4)]

## T: No restriction beyond the scene itself.
terminate after 20 seconds
