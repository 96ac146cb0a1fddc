## G: Noon with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A lane of at least 120 m.
lane = Uniform(*filter(lambda l: l.centerline.length > 120, network.lanes))
start = new OrientedPoint on lane.centerline

## E: The ego car drives at 12 m/s, then brakes hard to a stop after 4 seconds.
behavior EgoStops():
    do FollowLaneBehavior(target_speed=12) for 4 seconds
    while True:
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoStops()

## O1: A truck follows ego 12 m behind in the same lane at the same speed and brakes when it comes closer than 6 m.
behavior Tailgates():
    try:
        do FollowLaneBehavior(target_speed=12)
    interrupt when (distance from self to ego) < 10:
        take SetThrottleAction(0), SetBrakeAction(1)

behindSpot = new OrientedPoint following roadDirection from start for -18
tailgater = new Truck at behindSpot,
    with name 'tailgater',
    with behavior Tailgates()

## T: The truck is in ego's lane; the run ends after 12 seconds.
require lane.containsPoint(tailgater.position)
terminate after 12 seconds
