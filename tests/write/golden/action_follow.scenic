## G
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R
place = Uniform(*stretches(length=330, least=82))
EGO_AT = Range(30, 50)  # m along its lane

## E
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = way(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, lambda: pace(self, lead, EGO_SPEED))

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()

## O1
LEAD_SPEED = 12  # m/s
LEAD_AT = EGO_AT + 25 + 5  # m along the lane
lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior Cruise(way(place.lane), LEAD_SPEED)

## O2
FOLLOWER_SPEED = 12  # m/s
FOLLOWER_AT = EGO_AT - 15 - 5  # m along the lane

behavior FollowerBehavior():
    line = way(place.lane)
    try:
        take SetSpeedAction(FOLLOWER_SPEED)
        do Drive(line, lambda: pace(self, ego, FOLLOWER_SPEED, headway=0.92), rate=4)
    interrupt when most_need(self, [ego, lead]) > 3:
        do BrakeFor(line, [ego, lead])

follower = new Car at place.lane.centerline.pointAlongBy(FOLLOWER_AT),
    with blueprint Uniform(*CARS),
    with behavior FollowerBehavior()

## T
terminate after 20 seconds
