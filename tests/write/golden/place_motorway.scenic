## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: motorways.
egoLane = Uniform(*[lane
    for road in network.roads for lane in road.lanes
    if lane.road.id in {40, 41, 42, 43, 44, 45, 48, 49, 50} and len(lane.group.lanes) >= 3 and lane.sections[0]._fasterLane and lane.sections[0]._slowerLane and lane.centerline.length > 575])
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 27  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
