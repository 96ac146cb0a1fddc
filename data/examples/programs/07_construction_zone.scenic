## G: Overcast and wet.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'WetCloudyNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A lane of at least 120 m.
lane = Uniform(*filter(lambda l: l.centerline.length > 120, network.lanes))
start = new OrientedPoint on lane.centerline

## E: The ego car drives at 8 m/s and stops for what stands in its lane.
behavior EgoStopsForObstacles():
    try:
        do FollowLaneBehavior(target_speed=8)
    interrupt when withinDistanceToObjsInLane(self, 12):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoStopsForObstacles()

## O1: Three cones stand across ego's lane, 45 m ahead.
worksSpot = new OrientedPoint following roadDirection from start for 45
middleCone = new Cone at worksSpot, with name 'middleCone'
leftCone = new Cone left of worksSpot by 1.2, with name 'leftCone', with regionContainedIn None
rightCone = new Cone right of worksSpot by 1.2, with name 'rightCone', with regionContainedIn None

## O2: A warning sign stands at the right edge of the lane, 15 m before the cones.
signSpot = new OrientedPoint following roadDirection from start for 30
sign = new TrafficWarning right of signSpot by 2.5,
    with name 'sign',
    with regionContainedIn None

## T: The run ends after 15 seconds.
terminate after 15 seconds
