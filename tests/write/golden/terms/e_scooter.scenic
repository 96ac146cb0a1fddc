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

## E: Ego, a car, drives at 28.8 km/h.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A bicycle at the right roadside, 50 m away, slowly; it crosses the road.
E_SCOOTER_SPEED = Range(2.2, 3.3)  # m/s
E_SCOOTER_GAP = 50  # m, bumper to bumper
E_SCOOTER_AT = EGO_AT + E_SCOOTER_GAP + 3.5  # m along the lane; their bodies take 3.5
E_SCOOTER_ARRIVES = Range(-1.27, -0.87)  # s after ego in the middle of its way, unhindered

behavior EScooterBehavior():
    line = route(place.lane)
    do Stop(straight_on(self)) until sets_out(self, ego, line, E_SCOOTER_SPEED, E_SCOOTER_ARRIVES, 1.5)
    far = to_far_side(self, line, self.heading) + 14
    do Drive(straight_on(self, far), E_SCOOTER_SPEED, rate=1.5)

e_scooter = new Bicycle at beside(place.lane.rightEdge, place.lane, E_SCOOTER_AT, 1.8),
    facing 90 deg relative to heading_at(place.lane, E_SCOOTER_AT),
    with regionContainedIn everywhere,
    with blueprint Uniform(*BICYCLES),
    with behavior EScooterBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
