## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=225, min_length=99,
    ego_lane='rightmost'), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it brakes for what comes into its way.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, pusher) > 2.5:  # m/s2
        do BrakeFor(line, pusher)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A bicycle at the right roadside, 50 m away, at walking pace; it crosses the road.
PUSHER_SPEED = Range(1.1, 2)  # m/s
PUSHER_GAP = 50  # m, bumper to bumper
PUSHER_AT = EGO_AT + PUSHER_GAP + 3.5  # m along the lane; their bodies take 3.5
PUSHER_ARRIVES = Range(-0.2, 0)  # s after ego in the middle of its way, unhindered

behavior PusherBehavior():
    line = route(place.lane)
    do Stop(straight_on(self)) until sets_out(self, ego, line, PUSHER_SPEED, PUSHER_ARRIVES, 1.5)
    far = to_far_side(self, line, self.heading) + 14
    do Drive(straight_on(self, far), PUSHER_SPEED, rate=1.5)

pusher = new Bicycle at beside(place.lane.rightEdge, place.lane, PUSHER_AT, 1.8),
    facing 90 deg relative to heading_at(place.lane, PUSHER_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*BICYCLES),
    with behavior PusherBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
