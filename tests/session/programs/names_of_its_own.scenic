'''Names that the driving library has, too, with another meaning.'''
param map = localPath('town.xodr')
param use2DMap = True
model scenic.domains.driving.model

## a helper of mine
def gap(a, b):
    return distance from a to b

EGO_AT = 7  # the age of my cat
lane = Uniform(*network.lanes)

bus = new Car on lane.centerline, with behavior FollowLaneBehavior(target_speed=8)

behavior Waits():
    do FollowLaneBehavior(target_speed=9) until gap(self, bus) < 20
    do FollowLaneBehavior(target_speed=4)

ego = new Car behind bus by 30, with behavior Waits()
terminate after 12 seconds
