## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: intersections without lights and signs.
junction = Uniform(*[j
    for j in [(m, approach(m, -90, ManeuverType.RIGHT_TURN)) for m in [m for i in network.intersections for m in i.maneuvers
    if i.id in {109, 110, 113} and m.type is ManeuverType.STRAIGHT and m.startLane.centerline.length > 69]] if all(j)])
egoTurn = junction[0]
egoLane = egoTurn.startLane
leftApproach = junction[1]
EGO_TO_JUNCTION = 44  # m
EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = way(egoLane, egoTurn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, turner) > 3:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, turner)))) until need(self, turner) <= 0

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
TURNER_SPEED = 11  # m/s
TURNER_TO_JUNCTION = 38.2  # m

behavior TurnerBehavior():
    line = way(leftApproach, ManeuverType.RIGHT_TURN)
    spot = meeting(line, way(egoLane, egoTurn))
    take SetSpeedAction(TURNER_SPEED)
    do Drive(line, lambda: meet(self, ego, spot, TURNER_SPEED, 2)) until self._intersection
    do Drive(line, lambda: meet(self, ego, spot, TURNER_SPEED, 2))

turner = new Car at leftApproach.centerline.pointAlongBy(-TURNER_TO_JUNCTION),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior TurnerBehavior()

## T
terminate after 20 seconds
