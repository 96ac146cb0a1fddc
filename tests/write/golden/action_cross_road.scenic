## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=375, min_length=130, ego_lane='rightmost',
    speed=15), speed=13.9))
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, walker) > 3:  # m/s2
        do YieldTo(line, [walker], EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
WALKER_SPEED = 1.4  # m/s
WALKER_GAP = 81.91  # m, bumper to bumper
WALKER_AT = EGO_AT + WALKER_GAP + 2.85  # m along the lane; their bodies take 2.85
WALKER_ARRIVES = Range(-0.2, 0)  # s after ego in the middle of its way, unhindered

behavior WalkerBehavior():
    line = route(place.lane)
    do Stand() until sets_out(self, ego, line, WALKER_SPEED, WALKER_ARRIVES)
    do Walk(self.heading, WALKER_SPEED, to_far_side(self, line, self.heading))

walker = new Pedestrian at beside(place.lane.rightEdge, place.lane, WALKER_AT, 3),
    facing 90 deg relative to heading_at(place.lane, WALKER_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*PEDESTRIANS),
    with behavior WalkerBehavior()

## T
terminate after 20 seconds
