## G: Noon with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: A straight lane long enough for ego and a car ahead of it.
lane = Uniform(*filter(lambda l: l.centerline.length > 120, network.lanes))
start = new OrientedPoint on lane.centerline

## E: The ego car drives at 10 m/s and brakes hard as soon as something is less than 12 m away.
EGO_SPEED = Range(9, 11)
SAFE_DISTANCE = 12

behavior EgoDrivesAndBrakes():
    try:
        do FollowLaneBehavior(target_speed=EGO_SPEED)
    interrupt when withinDistanceToAnyObjs(self, SAFE_DISTANCE):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoDrivesAndBrakes()

## O1: A car drives 20 to 30 m ahead of ego in the same lane and brakes to a stop after 5 seconds.
LEAD_SPEED = Range(7, 9)

behavior LeadBrakes():
    do FollowLaneBehavior(target_speed=LEAD_SPEED) for 5 seconds
    while True:
        take SetThrottleAction(0), SetBrakeAction(1)

leadSpot = new OrientedPoint following roadDirection from start for Range(25, 35)
lead = new Car at leadSpot,
    with name 'lead',
    with behavior LeadBrakes()

## T: The lead car is on the same lane, and the run ends 15 seconds after the start.
require lane.containsPoint(lead.position)
terminate after 15 seconds
