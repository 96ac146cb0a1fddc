## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*ordinary(stretches(length=330, min_length=82), speed=12))
EGO_AT = Range(30, 50)  # m along its lane

## E
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: following_speed(self, lead, EGO_SPEED))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1
LEAD_SPEED = 12  # m/s
LEAD_GAP = 25  # m, bumper to bumper
LEAD_AT = EGO_AT + LEAD_GAP + 5  # m along the lane; their bodies take 5
lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(route(place.lane), LEAD_SPEED)

## O2
FOLLOWER_SPEED = 12  # m/s
FOLLOWER_GAP = 15  # m, bumper to bumper
FOLLOWER_AT = EGO_AT - FOLLOWER_GAP - 5  # m along the lane; their bodies take 5

behavior FollowerBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(FOLLOWER_SPEED)
        do Drive(line, lambda: following_speed(self, ego, FOLLOWER_SPEED, headway=0.92), rate=4)
    interrupt when braking_needed(self, [ego, lead]) > 3:  # m/s2
        do BrakeFor(line, [ego, lead])

follower = new Car at place.lane.centerline.pointAlongBy(FOLLOWER_AT),
    with blueprint Uniform(*CARS),
    with behavior FollowerBehavior()

## T
terminate after 20 seconds
