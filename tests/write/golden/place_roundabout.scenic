## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: ways into the roundabout.
egoTurn = Uniform(*[m
    for i in network.intersections for m in i.maneuvers
    if (i.id, m.startLane.road.id) in {(121, 30), (122, 27), (123, 16), (124, 28), (141, 71), (142, 70), (143, 72)} and m.startLane.centerline.length > 60])
egoLane = egoTurn.startLane
EGO_TO_JUNCTION = 35  # m
EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = way(egoLane, egoTurn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
