## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: where crosswalks cross lanes.
spots = [Vector(1122.0, -1.8), Vector(1122.0, -5.2), Vector(1122.0, -8.8), Vector(1122.0, 1.8), Vector(1122.0, 5.2), Vector(1122.0, 8.8), Vector(-598.3, 251.0), Vector(-594.8, 251.0), Vector(-601.8, 251.0), Vector(-605.3, 251.0), Vector(-960.0, 498.2), Vector(-960.0, 501.8), Vector(-299.0, 498.2), Vector(-299.0, 501.8), Vector(-302.0, 998.4), Vector(-302.0, 1001.6)]
crossing = Uniform(*[(network.laneAt(s), along(network.laneAt(s), s)) for s in spots])
egoLane = crossing[0]
EGO_TO_CROSSWALK = 44  # m
EGO_AT = crossing[1] - EGO_TO_CROSSWALK

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
