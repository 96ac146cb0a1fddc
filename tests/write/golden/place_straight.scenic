## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

stretch = Uniform(*[(lane, o)
    for lane in [lane for road in network.roads for lane in road.lanes
    if lane.group._opposite is not None and (lane.centerline[-1] - lane.centerline[0]).norm() > 0.998 * lane.centerline.length and any(a.group is lane.group._opposite for x in lane.group.lanes for a in x.adjacentLanes) and lane.centerline.length > 325] for o in lane.group.opposite.lanes if o.sections[0]._fasterLane is None])
egoLane = stretch[0]
oncomingLane = stretch[-1]
EGO_AT = Range(25, 45)  # m along its lane

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
