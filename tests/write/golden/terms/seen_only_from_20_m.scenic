## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=104, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it brakes for what comes into its way.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, in_view(self, [child], [van])) > 3:  # m/s2
        do YieldTo(line, [child], EGO_SPEED)

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

## O2: A child at the right roadside, hidden by the van; it crosses the road at a distance of 20 m.
CHILD_SPEED = 2.2  # m/s

behavior ChildBehavior():
    line = route(place.lane)
    do Stand() until gap(self, ego) < 23.6  # 20 m away as it comes out from behind what hides it
    do Walk(self.heading, CHILD_SPEED, to_far_side(self, line, self.heading))

child = new Pedestrian at van offset by 1 @ (van.length / 2 + 0.65),
    facing 90 deg relative to van,
    with regionContainedIn everywhere,
    with blueprint Uniform(*CHILDREN),
    with rolename 'child',
    with behavior ChildBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
