## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: on-ramps.
merge = Uniform(*[(m, o)
    for m in [m for i in network.intersections for m in i.maneuvers
    if m.startLane.road.id in {47} and m.startLane.centerline.length > 101] for o in m.intersection.maneuvers if o.endLane is m.endLane.sections[0]._fasterLane.lane])  # the ramp's way and that of the lane beside it
egoTurn = merge[0]
egoLane = egoTurn.startLane
accelerationLane = egoTurn.endLane
leftLane = merge[1].startLane
EGO_TO_JUNCTION = 76  # m
EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 19  # m/s

behavior EgoBehavior():
    line = way(egoLane, egoTurn)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until self._lane is accelerationLane
    line = way(leftLane)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
