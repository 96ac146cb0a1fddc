## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

egoTurn = Uniform(*[m
    for i in network.intersections for m in i.maneuvers
    if i.is4Way and i.isSignalized and m.type is ManeuverType.LEFT_TURN and m.startLane.centerline.length > 69])
egoLane = egoTurn.startLane
EGO_TO_JUNCTION = 44  # m
EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = way(egoLane, egoTurn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
