## G
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R
import math

egoLane = Uniform(*[lane
    for road in network.roads for lane in road.lanes
    if lane.group._opposite is not None and lane.sections[0]._slowerLane is None and lane.centerline.length > 375])
EGO_AT = Range(25, 45)  # m along its lane

## E
EGO_SPEED = 13.9  # m/s

behavior EgoBehavior():
    line = way(egoLane)
    try:
        take SetSpeedAction(EGO_SPEED)
        do Drive(line, EGO_SPEED)
    interrupt when need(self, walker) > 2:
        do Drive(line, 0, rate=lambda: max(4.0, min(9, 1.1 * need(self, walker)))) until need(self, walker) <= 0 and passed(walker, self)

ego = new Car at egoLane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1
WALKER_SPEED = 1.4  # m/s
WALKER_AT = EGO_AT + 55.6 + 2.85  # m along the lane

behavior WalkerBehavior():
    while not ((distance from self to ego) < 3.39 * ego.speed + 4):
        wait
    do Walk(self.heading, WALKER_SPEED)

walker = new Pedestrian at (new OrientedPoint at egoLane.rightEdge.project(egoLane.centerline.pointAlongBy(WALKER_AT)), facing roadDirection at egoLane.centerline.pointAlongBy(WALKER_AT)) offset by 3 @ 0,
    facing 90 deg relative to (roadDirection at egoLane.centerline.pointAlongBy(WALKER_AT)),
    with regionContainedIn everywhere,
    with blueprint Uniform('walker.pedestrian.0001', 'walker.pedestrian.0002', 'walker.pedestrian.0003', 'walker.pedestrian.0005', 'walker.pedestrian.0006'),
    with behavior WalkerBehavior()

## T
terminate after 20 seconds
