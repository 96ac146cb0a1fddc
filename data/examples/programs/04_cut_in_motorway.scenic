## G: Light rain at noon.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'SoftRainNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A carriageway where ego's lane has a neighbour of the same direction on its left.
withLeft = filter(lambda s: s._laneToLeft is not None and s._laneToLeft.isForward == s.isForward and s.centerline.length > 150, network.laneSections)
section = Uniform(*withLeft)
leftSection = section.laneToLeft
start = new OrientedPoint on section.centerline

## E: The ego car keeps its lane at 15 m/s and brakes when a vehicle in its lane comes closer than 10 m.
behavior EgoKeepsLane():
    try:
        do FollowLaneBehavior(target_speed=15)
    interrupt when withinDistanceToObjsInLane(self, 10):
        take SetThrottleAction(0), SetBrakeAction(0.8)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoKeepsLane()

## O1: A car on the left lane, 10 to 15 m ahead of ego, cuts into ego's lane after 3 seconds and slows down.
behavior CutsIn():
    do FollowLaneBehavior(target_speed=15) for 3 seconds
    do LaneChangeBehavior(laneSectionToSwitch=section, target_speed=14)
    do FollowLaneBehavior(target_speed=11)

beside = new OrientedPoint at leftSection.centerline.project(start.position)
cutterSpot = new OrientedPoint following roadDirection from beside for Range(12, 18)
cutter = new Car at cutterSpot,
    with name 'cutter',
    with behavior CutsIn()

## T: The other car starts on the left lane; the run ends after 20 seconds.
require leftSection.containsPoint(cutter.position)
terminate after 20 seconds
