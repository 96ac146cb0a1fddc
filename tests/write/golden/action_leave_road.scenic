## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

egoLane = Uniform(*[lane
    for road in network.roads for lane in road.lanes
    if lane.group._opposite is not None and lane.sections[0]._slowerLane is None and lane.centerline.length > 325])
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 14  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
LOSER_SPEED = 14  # m/s
LOSER_AT = EGO_AT + 30 + 5  # m along the lane

behavior LoserBehavior():
    line = way(egoLane)
    take SetSpeedAction(LOSER_SPEED)
    do Drive(line, LOSER_SPEED) for 3 seconds
    do Drive(line, LOSER_SPEED, offset=-egoLane.group.rightEdge.distanceTo(self.position) - 4, shift=2)

loser = new Car at egoLane.centerline.pointAlongBy(LOSER_AT),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior LoserBehavior()

## T
terminate after 20 seconds
