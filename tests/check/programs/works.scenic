param map = localPath('town.xodr')
param carla_map = None
param weather = 'SoftRainNoon'
model scenic.simulators.carla.model

ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(5)
first = new OrientedPoint following roadDirection from ego for Range(20, 30)
cones = [new Cone following roadDirection from first for 3 * i, with regionContainedIn None for i in range(4)]
barrier = new Barrier following roadDirection from first for 14, with regionContainedIn None, facing 90 deg relative to roadDirection
