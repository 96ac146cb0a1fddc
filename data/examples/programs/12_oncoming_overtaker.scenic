## G: Noon with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A road with one lane in each direction, where the neighbour on the left is oncoming.
withOncoming = filter(lambda s: s._laneToLeft is not None and s._laneToLeft.isForward != s.isForward and s.centerline.length > 100, network.laneSections)
section = Uniform(*withOncoming)
oncomingSection = section.laneToLeft
start = new OrientedPoint on section.centerline

## E: The ego car drives at 9 m/s and brakes when something comes closer than 20 m in its lane.
behavior EgoBrakes():
    try:
        do FollowLaneBehavior(target_speed=9)
    interrupt when withinDistanceToObjsInLane(self, 20):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoBrakes()

## O1: A car comes towards ego on the oncoming lane, 60 to 70 m ahead, at 8 m/s.
behavior ComesTowards():
    do FollowLaneBehavior(target_speed=8)

ahead60 = new OrientedPoint following roadDirection from start for Range(60, 70)
otherSpot = new OrientedPoint at oncomingSection.centerline.project(ahead60.position)
other = new Car at otherSpot,
    with name 'other',
    with behavior ComesTowards()

## T: The other car is on the oncoming lane; the run ends after 12 seconds.
require oncomingSection.containsPoint(other.position)
terminate after 12 seconds
