## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: approaches with a yield sign.
junction = Uniform(*[j
    for j in [(m, approach(m, 90, ManeuverType.STRAIGHT)) for m in [m for i in network.intersections for m in i.maneuvers
    if (i.id, m.startLane.road.id) in {(106, 9), (106, 15), (111, 31)} and m.type is ManeuverType.LEFT_TURN and m.startLane.centerline.length > 69]] if all(j)])
egoTurn = junction[0]
egoLane = egoTurn.startLane
rightApproach = junction[1]
EGO_TO_JUNCTION = 44  # m
EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = way(egoLane, egoTurn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED) until (distance from self to egoLane.centerline[-1]) < 4 + self.speed ** 2 / 6
        do Drive(line, 0, rate=3) until passed(crosser, self)
        do Drive(line, EGO_SPEED, rate=2)
    interrupt when need(self, crosser) > 3:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, crosser)))) until need(self, crosser) <= 0

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
CROSSER_SPEED = 11  # m/s
CROSSER_TO_JUNCTION = 47  # m

behavior CrosserBehavior():
    line = way(rightApproach, ManeuverType.STRAIGHT)
    spot = meeting(line, way(egoLane, egoTurn))
    try:
        take SetSpeedAction(CROSSER_SPEED)
        do Drive(line, lambda: meet(self, ego, spot, CROSSER_SPEED))
    interrupt when self._lane is ego._lane and need(self, ego) > 3:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, ego)))) until need(self, ego) <= 0

crosser = new Car at rightApproach.centerline.pointAlongBy(-CROSSER_TO_JUNCTION),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior CrosserBehavior()

## T
terminate after 20 seconds
