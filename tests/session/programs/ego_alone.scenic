"""Ego alone, which brakes for whatever is near."""
param map = localPath('town.xodr')
param use2DMap = True
model scenic.simulators.carla.model

EGO_MODEL = "vehicle.lincoln.mkz_2017"  # as in all our tests

behavior EgoBehavior(speed=10):
    try:
        do FollowLaneBehavior(speed)
    interrupt when withinDistanceToAnyObjs(self, 12):
        take SetBrakeAction(1.0)

lane = Uniform(*network.lanes)
start = new OrientedPoint on lane.centerline
ego = new Car at start,
    with blueprint EGO_MODEL,
    with behavior EgoBehavior(10)

require (distance from ego to intersection) > 60
terminate after 12 seconds
