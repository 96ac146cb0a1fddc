## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: off-ramps.
egoTurn = Uniform(*[m
    for i in network.intersections for m in i.maneuvers
    if m.endLane.road.id in {46} and m.startLane.centerline.length > 113])
egoLane = egoTurn.startLane
EGO_TO_JUNCTION = 88  # m
EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 22  # m/s

behavior EgoBehavior():
    line = way(egoLane, egoTurn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
