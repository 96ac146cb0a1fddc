## G: Noon with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.lincoln.mkz_2017'

## R: Ego approaches a signalised four-way intersection where it turns left; another way leads straight from the opposite side.
crossroads = filter(lambda i: i.is4Way and i.isSignalized, network.intersections)
pairs = [(turn, way) for i in crossroads for turn in i.maneuvers for way in i.maneuvers
         if turn.type is ManeuverType.LEFT_TURN and way.type is ManeuverType.STRAIGHT
         and way.endLane.road is turn.startLane.road]
pair = Uniform(*pairs)
egoTurn, oncomingWay = pair[0], pair[1]
egoPath = [egoTurn.startLane, egoTurn.connectingLane, egoTurn.endLane]
oncomingPath = [oncomingWay.startLane, oncomingWay.connectingLane, oncomingWay.endLane]

## E: The ego car turns left at the intersection at 7 m/s and brakes for what comes closer than 10 m.
behavior EgoTurnsLeft():
    try:
        do FollowTrajectoryBehavior(target_speed=7, trajectory=egoPath)
    interrupt when withinDistanceToAnyObjs(self, 10):
        take SetThrottleAction(0), SetBrakeAction(1)

start = new OrientedPoint following roadDirection from egoTurn.startLane.centerline.end for Range(-35, -25)
ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoTurnsLeft()

## O1: A truck comes from the opposite direction and goes straight over the intersection at 8 m/s.
behavior GoesStraight():
    do FollowTrajectoryBehavior(target_speed=8, trajectory=oncomingPath)

truckSpot = new OrientedPoint following roadDirection from oncomingWay.startLane.centerline.end for Range(-35, -25)
truck = new Truck at truckSpot,
    with name 'truck',
    with behavior GoesStraight()

## T: Ego and the truck are on their lanes; the run ends when ego is 60 m away from its start.
require egoTurn.startLane.containsPoint(ego.position)
require oncomingWay.startLane.containsPoint(truck.position)
terminate when (distance to start) > 60
