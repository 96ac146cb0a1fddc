## G: Clear weather, day, ego's light green.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: An intersection with traffic lights, where ego turns left.
place = Uniform(*ordinary(junctions(LEFT_TURN, control='signal', approach=69,
    others=[From('opposite')]), speed=11))
EGO_TO_JUNCTION = 44  # m
EGO_AT = place.length - EGO_TO_JUNCTION

## E: Ego, a car, drives at 39.6 km/h; it waits when it is in the intersection, then turns left when the actor1 has gone by ego; it lets the other pass.
EGO_SPEED = 11  # m/s

behavior EgoBehavior():
    line = route(place.lane, place.turn)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED) for 3 seconds
        do Drive(line, lambda: short_of_ways(self, line, [actor1], EGO_SPEED, room=4), rate=5) until self.speed < 0.2
        do Stop(line, rate=4) until passed(actor1, self, 0)
        do Drive(line, EGO_SPEED)  # turns left
    interrupt when braking_needed(self, actor1) > 3:  # m/s2
        do BrakeFor(line, actor1)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights(place.turn)  # in CARLA: ego's is green

## O1: A car on the opposite approach of the intersection; it goes straight on.
ACTOR1_SPEED = 11  # m/s
ACTOR1_AFTER = Range(2.2, 2.8)  # s after ego where their ways cross, if neither reacts
ACTOR1_TO_JUNCTION = start_to_meet(
    place.from_opposite, route(place.from_opposite), ACTOR1_SPEED,
    route(place.lane, place.turn), EGO_AT, EGO_SPEED, ahead=-ACTOR1_AFTER)  # m
actor1 = new Car at place.from_opposite.centerline.pointAlongBy(-ACTOR1_TO_JUNCTION),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.from_opposite), ACTOR1_SPEED)

## T: No restriction beyond the scene itself.
terminate after 20 seconds
