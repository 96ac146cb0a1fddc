## G: Clear weather, day.
param map = localPath('town.xodr')
param carla_map = None
param use2DMap = True
param weather = 'ClearNoon'
model scenic.simulators.carla.model
from c2s_driving import *

## R: A motorway, 2 or more lanes in ego's direction, ego in the rightmost.
place = Uniform(*motorways(length=425, min_length=172, lanes=2, ego_lane='rightmost', speed=17.5))
EGO_AT = Range(25, 45)  # m along its lane

## E: Ego, a car, drives at 57.6 km/h; it changes lane to the left at a distance of 50 m.
EGO_SPEED = 16  # m/s

behavior EgoBehavior():
    line = route(place.lane)
    take SetSpeedAction(EGO_SPEED)
    do Drive(line, EGO_SPEED) until gap(self, end[0]) < 50
    line = route(place.left_lane)
    do Drive(line, EGO_SPEED)  # changes lane to the left

ego = new Car at place.lane.centerline.pointAlongBy(EGO_AT),
    with blueprint 'vehicle.lincoln.mkz_2017',
    with behavior EgoBehavior()

## O1: A lane closure ahead of ego in the same lane, 110 m away.
END_GAP = 110  # m, bumper to bumper
END_AT = EGO_AT + END_GAP + 8.6  # m along the lane; their bodies take 8.6
end_spot = new OrientedPoint at place.lane.centerline.pointAlongBy(END_AT), facing roadDirection
end = [new Cone at end_spot offset by x @ y, with blueprint 'static.prop.trafficcone01', with regionContainedIn everywhere
    for x, y in ((-1.4, -6), (-0.5, -4), (0.5, -2), (1.4, 0), (1.4, 4), (1.4, 8))]
end_barrier = new Barrier at end_spot offset by 0 @ 5, facing end_spot.heading + 90 deg,
    with blueprint 'static.prop.streetbarrier', with regionContainedIn everywhere

## T: No restriction beyond the scene itself.
terminate after 20 seconds
