## G: A clear noon in the town.
param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

## R: A lane section that is long enough.
SPEED = 7
sections = filter(lambda s: s.centerline.length > 90, network.laneSections)
start = new OrientedPoint on Uniform(*sections).centerline

## E: Ego follows its lane and brakes for what comes near.
behavior EgoBehavior(speed, gap):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToAnyObjs(self, gap):
        take SetThrottleAction(0), SetBrakeAction(1.0)

ego = new Car at start,
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior(SPEED, 10)

## O1: A car ahead that brakes after some seconds.
behavior LeadBehavior(speed, after):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when simulation().currentTime * 0.1 > after:
        take SetThrottleAction(0), SetBrakeAction(0.8)

lead = new Car following roadDirection from ego for Range(15, 30),
    with behavior LeadBehavior(SPEED, Range(3, 5))

## O2: A pedestrian beside the road.
walker = new Pedestrian right of ego by 6,
    with regionContainedIn None

## O3: A cone beyond the car.
cone = new Cone following roadDirection from lead for Range(8, 12),
    with regionContainedIn None

## T: The car begins within 60 m, and the run ends after 20 s.
require (distance from ego to lead) < 60
terminate after 20 seconds
