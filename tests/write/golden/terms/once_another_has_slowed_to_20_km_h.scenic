## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=325, min_length=102), speed=12))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 43.2 km/h; it brakes when the lead goes at 20.2 km/h.
EGO_SPEED = 12  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until clock() > 0.5 and abs(lead.speed - 5.6) < 0.45
    do Drive(line, EGO_SPEED / 2, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A car ahead of ego in the same lane, 50 m away, at 43.2 km/h; it brakes.
LEAD_SPEED = 12  # m/s
LEAD_GAP = 50  # m, bumper to bumper
LEAD_AT = EGO_AT + LEAD_GAP + 5  # m along the lane; their bodies take 5

behavior LeadBehavior():
    line = route(place.lane)
    take SetSpeedAction(LEAD_SPEED)
    do Drive(line, LEAD_SPEED) for 3 seconds
    do Drive(line, 5, rate=3)  # brakes

lead = new Car at place.lane.centerline.pointAlongBy(LEAD_AT),
    with blueprint Uniform(*CARS),
    with behavior LeadBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
