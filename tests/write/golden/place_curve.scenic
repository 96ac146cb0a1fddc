## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

stretch = Uniform(*[(lane, bend_start(lane))
    for lane in [lane for road in network.roads for lane in road.lanes
    if lane.group._opposite is not None and (lane.centerline[1] - lane.centerline[0]).angleWith(lane.centerline[-1] - lane.centerline[-2]) > 0.35 and lane.centerline.length > 325]])
egoLane = stretch[0]
EGO_TO_BEND = 40  # m
EGO_AT = max(25, stretch[1] - EGO_TO_BEND)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## T
terminate after 20 seconds
