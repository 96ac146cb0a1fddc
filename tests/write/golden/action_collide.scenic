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
    if lane.group._opposite is not None and lane.centerline.length > 435])
EGO_AT = Range(35, 55)  # m along its lane

## E
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
RAMMER_SPEED = 18  # m/s
RAMMER_AT = EGO_AT - 20 - 5  # m along the lane

behavior RammerBehavior():
    line = way(egoLane)
    take SetSpeedAction(RAMMER_SPEED)
    do Drive(line, RAMMER_SPEED) until near(self, ego)
    do Ram(ego, 18)

rammer = new Car at egoLane.centerline.pointAlongBy(RAMMER_AT),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior RammerBehavior()

## T
terminate after 20 seconds
