## G: A cloudy day.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'CloudyNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.tesla.model3'

## R: A lane at the edge of the road, with a stretch of 80 m before its end.
outerLanes = filter(lambda g: g.lanes[0].centerline.length > 120, network.laneGroups)
laneGroup = Uniform(*outerLanes)
lane = laneGroup.lanes[0]
start = new OrientedPoint on lane.centerline

## E: The ego car drives at 8 m/s and brakes when a pedestrian is closer than 15 m.
EGO_SPEED = 8

behavior EgoBrakesForPedestrians():
    try:
        do FollowLaneBehavior(target_speed=EGO_SPEED)
    interrupt when withinDistanceToAnyPedestrians(self, 15):
        take SetThrottleAction(0), SetBrakeAction(1)

ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoBrakesForPedestrians()

## O1: A van is parked at the right edge of the road, 35 to 40 m ahead of ego.
vanSpot = new OrientedPoint following roadDirection from start for Range(35, 40)
parkedVan = new Van right of vanSpot by 2.2,
    with name 'parkedVan',
    with regionContainedIn None,
    with requireVisible False

## O2: A pedestrian behind the parked van walks onto the road from the right when ego is 20 m away.
behavior StepsOut(distance=20):
    while (distance from self to ego) > distance:
        wait
    take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(1.5)

walkerSpot = new OrientedPoint following roadDirection from vanSpot for 5
walker = new Pedestrian right of walkerSpot by 2.5,
    facing 90 deg relative to roadDirection,
    with name 'walker',
    with regionContainedIn None,
    with behavior StepsOut()

## T: Ego is at least 20 m from the pedestrian at the start; the run ends when ego has passed it by 10 m.
require (distance from ego to walker) > 20
terminate when (distance from ego to start) > 60
