## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=104, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=10))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 36 km/h; it brakes when it can see the kid.
EGO_SPEED = 10  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until not hides(van, self.position, kid.position)
    do Drive(line, EGO_SPEED / 2, rate=3)  # brakes

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: A van parked on the right, 50 m away.
VAN_GAP = 50  # m, bumper to bumper
VAN_AT = EGO_AT + VAN_GAP + 5.55  # m along the lane; their bodies take 5.55
van = new Van at beside(place.lane.rightEdge, place.lane, VAN_AT, 1.6),
    facing heading_at(place.lane, VAN_AT),
    with regionContainedIn everywhere,
    with blueprint 'vehicle.mercedes.sprinter'

## O2: A child at the right roadside, hidden by the van; it crosses the road.
KID_SPEED = 2.2  # m/s
KID_ARRIVES = Range(-0.72, -0.52)  # s after ego in the middle of its way, unhindered

behavior KidBehavior():
    line = route(place.lane)
    do Stand() until sets_out(self, ego, line, KID_SPEED, KID_ARRIVES)
    do Walk(self.heading, KID_SPEED, to_far_side(self, line, self.heading))

kid = new Pedestrian ahead of van by 0.4,
    facing 90 deg relative to van,
    with regionContainedIn everywhere,
    with blueprint Uniform(*CHILDREN),
    with rolename 'child',
    with behavior KidBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
