## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(junctions(LEFT_TURN, control='yield', approach=69,
    others=[From('right', priority=True)]), speed=11))
EGO_TO_JUNCTION = 44  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED) until to_line(self, place.lane) < 0.5 + self.speed ** 2 / 6
        do Drive(line, lambda: up_to(to_line(self, place.lane), EGO_SPEED), rate=5) until passed(crosser, self)
        do Drive(line, EGO_SPEED, rate=2)
    interrupt when braking_needed(self, crosser) > 3:  # m/s2
        do BrakeFor(line, crosser)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1
CROSSER_SPEED = 11  # m/s
CROSSER_AHEAD = Range(-0.3, 0.3)  # s before ego where their ways cross, if neither reacts
CROSSER_TO_JUNCTION = start_to_meet(
    place.from_right, route(place.from_right), CROSSER_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=CROSSER_AHEAD)  # m

behavior CrosserBehavior():
    line = route(place.from_right)
    try:
        take SetSpeedAction(CROSSER_SPEED)
        do Drive(line, CROSSER_SPEED)
    interrupt when self._lane is ego._lane and braking_needed(self, ego) > 3:  # m/s2
        do BrakeFor(line, ego)

crosser = new Car at place.from_right.centerline.pointAlongBy(-CROSSER_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior CrosserBehavior()

## T
terminate after 20 seconds
