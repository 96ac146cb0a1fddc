## G: Night with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = {'cloudiness': 10, 'sun_altitude_angle': -30}
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: Ego turns right at an intersection.
junctions = filter(lambda i: i.is4Way or i.is3Way, network.intersections)
junction = Uniform(*junctions)
rightTurns = filter(lambda m: m.type is ManeuverType.RIGHT_TURN, junction.maneuvers)
egoTurn = Uniform(*rightTurns)
egoPath = [egoTurn.startLane, egoTurn.connectingLane, egoTurn.endLane]

## E: The ego car turns right at 6 m/s and brakes for pedestrians closer than 10 m.
behavior EgoTurnsRight():
    try:
        do FollowTrajectoryBehavior(target_speed=6, trajectory=egoPath)
    interrupt when withinDistanceToAnyPedestrians(self, 10):
        take SetThrottleAction(0), SetBrakeAction(1)

start = new OrientedPoint following roadDirection from egoTurn.startLane.centerline.end for Range(-35, -15)
ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoTurnsRight()

## O1: A pedestrian stands at the edge of the lane into which ego turns and crosses it when ego is 15 m away.
behavior CrossesWhenNear(distance=15):
    while (distance from self to ego) > distance:
        wait
    take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(1.2)

exitSpot = new OrientedPoint following roadDirection from egoTurn.endLane.centerline.start for 6
walker = new Pedestrian right of exitSpot by 3,
    facing 90 deg relative to roadDirection,
    with name 'walker',
    with regionContainedIn None,
    with behavior CrossesWhenNear()

## T: Ego is at least 10 m from the pedestrian at the start; the run ends after 20 seconds.
require (distance from ego to walker) > 10
terminate after 20 seconds
