param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

spot = new OrientedPoint on Uniform(*filter(lambda s: s.centerline.length > 100, network.laneSections)).centerline
ego = new Car at spot, with behavior FollowLaneBehavior(7)
one = new Car following roadDirection from ego for Range(18, 22)
two = new Van following roadDirection from one for Range(8, 10)
three = new Truck following roadDirection from two for Range(10, 12)
