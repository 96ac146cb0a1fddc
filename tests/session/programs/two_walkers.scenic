# Nothing but comments first,
# and more than one object.

param map = localPath('town.xodr')

param weather = 'WetNoon'
model scenic.simulators.carla.model
param EGO_SPEED = 8

behavior Brakes(speed=8, threshold=12):
    try:
        do FollowLaneBehavior(speed)
    interrupt when withinDistanceToObjsInLane(self, threshold):
        take SetBrakeAction(1.0)

WALK = Range(0.8, 1.4)
lane = Uniform(*network.lanes)
start = new OrientedPoint on lane.centerline
ego = new Car at start,
    with behavior Brakes(globalParameters.EGO_SPEED)
first = new Pedestrian right of start by 4,
    with regionContainedIn None,
    with behavior CrossingBehavior(ego, WALK, 12)
second = new Pedestrian left of start by 4, with regionContainedIn None  # stands
van = new Van following roadDirection from start for 30


# The end.
terminate after 15 seconds
