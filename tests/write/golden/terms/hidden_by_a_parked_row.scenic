## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A straight road.
place = Uniform(*ordinary(stretches(straight=True, length=375, min_length=102, ego_lane='rightmost',
    shoulder='preferred', speed=15), speed=8))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 28.8 km/h; it brakes for what comes into its way.
EGO_SPEED = 8  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when braking_needed(self, in_view(self, [child], row)) > 3:  # m/s2
        do YieldTo(line, [child], EGO_SPEED)

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()
require monitor Lights()  # in CARLA: all are green

## O1: 4 cars parked on the right, 30 m away, 2 m apart.
ROW_GAP = 30  # m, bumper to bumper
ROW_AT = EGO_AT + ROW_GAP + 5  # m along the lane; their bodies take 5
row = [new Car at beside(place.lane.rightEdge, place.lane, ROW_AT + 6.3 * i, 1.6),
    facing heading_at(place.lane, ROW_AT + 6.3 * i),
    with regionContainedIn everywhere,
    with blueprint Uniform(*CARS) for i in range(4)]

## O2: A child at the right roadside, hidden by the row; it crosses the road.
CHILD_SPEED = 2.2  # m/s
CHILD_ARRIVES = Range(-0.72, -0.52)  # s after ego in the middle of its way, unhindered

behavior ChildBehavior():
    line = route(place.lane)
    do Stand() until sets_out(self, ego, line, CHILD_SPEED, CHILD_ARRIVES)
    do Walk(self.heading, CHILD_SPEED, to_far_side(self, line, self.heading))

child = new Pedestrian ahead of row[-1] by 0.4,
    facing 90 deg relative to row[-1],
    with regionContainedIn everywhere,
    with blueprint Uniform(*CHILDREN),
    with rolename 'child',
    with behavior ChildBehavior()

## T: No restriction beyond the scene itself.
terminate after 20 seconds
