param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

area = CircularRegion(0 @ 0, 500)
ego = new Car in road, facing roadDirection
box = RectangularRegion(ego.position, 0, 80, 80)
thing = new Box in box, with regionContainedIn None
away = new Pedestrian offset by Range(-8, 8) @ Range(10, 20), with regionContainedIn None
