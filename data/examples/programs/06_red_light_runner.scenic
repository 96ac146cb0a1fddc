## G: Noon with a clear sky; the traffic light that ego faces is green.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

monitor TrafficLight():
    freezeTrafficLights()
    while True:
        setClosestTrafficLightStatus(ego, 'green')
        wait
require monitor TrafficLight()

## R: Ego goes straight over a signalised intersection; another way crosses its own.
crossroads = filter(lambda i: i.isSignalized, network.intersections)
junction = Uniform(*crossroads)
straights = filter(lambda m: m.type is ManeuverType.STRAIGHT and len(m.conflictingManeuvers) > 0, junction.maneuvers)
egoWay = Uniform(*straights)
egoPath = [egoWay.startLane, egoWay.connectingLane, egoWay.endLane]
crossing = Uniform(*filter(lambda m: m.type is ManeuverType.STRAIGHT, egoWay.conflictingManeuvers))
crossingPath = [crossing.startLane, crossing.connectingLane, crossing.endLane]

## E: The ego car goes straight over the intersection at 9 m/s and brakes hard when a car comes closer than 12 m.
behavior EgoGoesStraight():
    try:
        do FollowTrajectoryBehavior(target_speed=9, trajectory=egoPath)
    interrupt when withinDistanceToAnyCars(self, 12):
        take SetThrottleAction(0), SetBrakeAction(1)

start = new OrientedPoint following roadDirection from egoWay.startLane.centerline.end for Range(-30, -20)
ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoGoesStraight()

## O1: A car on the crossing road drives through its red light at 10 m/s without braking.
behavior RunsRed():
    do FollowTrajectoryBehavior(target_speed=10, trajectory=crossingPath)

runnerSpot = new OrientedPoint following roadDirection from crossing.startLane.centerline.end for Range(-30, -20)
runner = new Car at runnerSpot,
    with name 'runner',
    with behavior RunsRed()

## T: The runner starts at least 15 m before the intersection; the run ends after 15 seconds.
require (distance from runner to junction) > 15
terminate after 15 seconds
