param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

class Slow(Car):
    limit: Range(2, 4)
    color: Color.withBytes([10, 20, 30])
class Blocked(Slow):
    speed: 0
behavior Crawl():
    do FollowLaneBehavior(target_speed=self.limit)
ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(7)
slow = new Slow following roadDirection from ego for Range(15, 30), with behavior Crawl()
