## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*junctions(STRAIGHT, control='signal', approach=69,
    others=[From('opposite', LEFT_TURN)]))
EGO_TO_JUNCTION = 44  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = way(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, turner) > 2.5:
        do Drive(line, 0, rate=lambda: max(1, min(9, 1.1 * need(self, turner)))) until need(self, turner) <= 0

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

monitor TrafficLight():
    freezeTrafficLights()
    while True:
        setClosestTrafficLightStatus(ego, 'green')
        wait
require monitor TrafficLight()

## O1
TURNER_SPEED = 11  # m/s
TURNER_AHEAD = Range(-0.3, 0.3)  # s before ego where their ways cross, if neither reacts
TURNER_TO_JUNCTION = start_to_meet(
    place.from_opposite, way(place.from_opposite, LEFT_TURN), TURNER_SPEED,
    way(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=TURNER_AHEAD)  # m

behavior TurnerBehavior():
    line = way(place.from_opposite, LEFT_TURN)
    take SetSpeedAction(TURNER_SPEED)
    do Drive(line, TURNER_SPEED) until self._intersection
    do Drive(line, TURNER_SPEED)

turner = new Car at place.from_opposite.centerline.pointAlongBy(-TURNER_TO_JUNCTION),
    with blueprint Uniform('vehicle.audi.a2', 'vehicle.audi.etron', 'vehicle.bmw.grandtourer', 'vehicle.chevrolet.impala', 'vehicle.lincoln.mkz_2017', 'vehicle.toyota.prius', 'vehicle.tesla.model3'),
    with behavior TurnerBehavior()

## T
require monitor OnceSeen([
    lambda: ego._lane is place.exit_lane,
    lambda: turner._intersection is not None,
])
terminate after 20 seconds
