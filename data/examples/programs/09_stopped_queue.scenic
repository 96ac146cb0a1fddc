## G: Fog in the morning.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = {'cloudiness': 60, 'fog_density': 60, 'fog_distance': 10, 'sun_altitude_angle': 20}
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A lane of at least 150 m.
lane = Uniform(*filter(lambda l: l.centerline.length > 150, network.lanes))
start = new OrientedPoint on lane.centerline

## E: The ego car drives at 12 m/s and brakes in an emergency 20 m before an obstacle.
behavior EgoEmergencyBrake():
    try:
        do FollowLaneBehavior(target_speed=12)
    interrupt when withinDistanceToAnyObjs(self, 20):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoEmergencyBrake()

## O1: A queue of two cars stands in ego's lane, 60 m ahead.
lastSpot = new OrientedPoint following roadDirection from start for 60
lastCar = new Car at lastSpot, with name 'lastCar'
firstSpot = new OrientedPoint following roadDirection from lastSpot for 8
firstCar = new Car at firstSpot, with name 'firstCar'

## T: The queue is in ego's lane; the run ends when ego stands.
require lane.containsPoint(firstCar.position)
terminate when ego.speed < 0.1 and (distance from ego to start) > 20
