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
    if lane.road.id in {40, 41, 42, 43, 44, 45, 48, 49, 50} and len(lane.group.lanes) >= 2 and lane.sections[0]._slowerLane is None and lane.centerline.length > 635])
leftLane = egoLane.sections[0]._fasterLane.lane
EGO_AT = Range(35, 55)  # m along its lane

## E
EGO_SPEED = 20  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
PASSER_SPEED = 28  # m/s
PASSER_AT = EGO_AT - 20 - 5  # m along the lane

behavior PasserBehavior():
    line = way(egoLane)
    take SetSpeedAction(PASSER_SPEED)
    do Drive(line, PASSER_SPEED) until (distance from self to ego) < 10 + 1.6 * self.speed
    line = way(leftLane)
    do Drive(line, lambda: gain(self, ego, PASSER_SPEED), rate=5) until lead_on(self, ego) > 12 + self.length
    line = way(egoLane)
    do Drive(line, PASSER_SPEED)

passer = new Car at egoLane.centerline.pointAlongBy(PASSER_AT),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior PasserBehavior()

## T
terminate after 20 seconds
