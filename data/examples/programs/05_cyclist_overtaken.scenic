## G: Sunset with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearSunset'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A lane of at least 100 m that is not part of an intersection.
lane = Uniform(*filter(lambda l: l.centerline.length > 100, network.lanes))
start = new OrientedPoint on lane.centerline

## E: The ego car drives at 9 m/s and slows down behind whoever is ahead in its lane.
behavior EgoFollows():
    try:
        do FollowLaneBehavior(target_speed=9)
    interrupt when withinDistanceToObjsInLane(self, 14):
        do FollowLaneBehavior(target_speed=3) for 1 seconds

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoFollows()

## O1: A cyclist rides 25 m ahead of ego in the same lane at 4 m/s.
behavior Rides():
    do FollowLaneBehavior(target_speed=4)

bikeSpot = new OrientedPoint following roadDirection from start for 25
cyclist = new Bicycle at bikeSpot,
    with name 'cyclist',
    with behavior Rides()

## T: The cyclist is in ego's lane at the start; the run ends after 20 seconds.
require lane.containsPoint(cyclist.position)
terminate after 20 seconds
