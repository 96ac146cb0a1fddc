## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

# From the map's file: approaches with a stop sign.
junction = Uniform(*[j
    for j in [(m, approach(m, 90, ManeuverType.STRAIGHT)) for m in [m for i in network.intersections for m in i.maneuvers
    if (i.id, m.startLane.road.id) in {(107, 13), (108, 14), (108, 21), (112, 22), (112, 24), (112, 25), (112, 26)} and m.type is ManeuverType.STRAIGHT and m.startLane.centerline.length > 69]] if all(j) and (j[0].intersection.id, j[1].road.id) in {(107, 13), (108, 14), (108, 21), (112, 22), (112, 24), (112, 25), (112, 26)}])
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
        do Drive(line, 0, rate=3.5) until self.speed < 0.2
        do Drive(line, 0, rate=3.5) for 1 seconds
        do Drive(line, 0, rate=4) for 1 seconds
        do Drive(line, EGO_SPEED, rate=2)
    interrupt when need(self, runner) > 3:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, runner)))) until need(self, runner) <= 0

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
RUNNER_SPEED = 11  # m/s
RUNNER_TO_JUNCTION = 47  # m

behavior RunnerBehavior():
    line = way(rightApproach, ManeuverType.STRAIGHT)
    take SetSpeedAction(RUNNER_SPEED)
    do Drive(line, RUNNER_SPEED)

runner = new Car at rightApproach.centerline.pointAlongBy(-RUNNER_TO_JUNCTION),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior RunnerBehavior()

## T
terminate after 20 seconds
