""" A badly parked car pulls in ahead of ego,
with a docstring that stands close to the code. """
param map = localPath('town.xodr')
param time_step = 1.0/10
model scenic.simulators.carla.model
import math

def gap_to(one, other):
    return math.hypot(one.position.x - other.position.x, one.position.y - other.position.y)

behavior PullIntoRoad():
    while (distance from self to ego) > 15:
        wait
    do FollowLaneBehavior(laneToFollow=ego.lane, target_speed=6)   # ego's own lane

ego = new Car with behavior FollowLaneBehavior(target_speed=8)

rightCurb = ego.laneGroup.curb
spot = new OrientedPoint on visible rightCurb
badAngle = Uniform(1.0, -1.0) * Range(10, 20) deg
# parked askew
parkedCar = new Car left of spot by 0.5,
                facing badAngle relative to roadDirection,
                with behavior PullIntoRoad()


monitor Near():
    while True:
        if gap_to(ego, parkedCar) < 1:
            terminate
        wait
require monitor Near()

require (distance to parkedCar) > 20
terminate after 20 seconds
