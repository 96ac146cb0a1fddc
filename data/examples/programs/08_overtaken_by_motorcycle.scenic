## G: Noon with a clear sky.
param map = localPath('town.xodr')
param carla_map = None
param timestep = 0.1
param weather = 'ClearNoon'
model scenic.simulators.carla.model

EGO_MODEL = 'vehicle.sprinter.mercedes'

## R: Ego's lane has a neighbour of the same direction on its left.
withLeft = filter(lambda s: s._laneToLeft is not None and s._laneToLeft.isForward == s.isForward and s.centerline.length > 150, network.laneSections)
section = Uniform(*withLeft)
leftSection = section.laneToLeft
start = new OrientedPoint on section.centerline

## E: The ego van drives at 10 m/s in its lane.
behavior EgoCruises():
    do FollowLaneBehavior(target_speed=10)

ego = new Van at start,
    with blueprint EGO_MODEL,
    with behavior EgoCruises()

## O1: A motorcycle on the left lane, 10 to 15 m behind ego, overtakes at 15 m/s.
behavior Overtakes():
    do FollowLaneBehavior(target_speed=15)

beside = new OrientedPoint at leftSection.centerline.project(start.position)
bikeSpot = new OrientedPoint following roadDirection from beside for Range(-20, -15)
motorcycle = new Motorcycle at bikeSpot,
    with name 'motorcycle',
    with behavior Overtakes()

## T: The motorcycle starts on the left lane; the run ends when it is 30 m ahead of ego.
require leftSection.containsPoint(motorcycle.position)
terminate when (distance from motorcycle to ego) > 30 and ego can see motorcycle
