param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

behavior Change(target):
    do FollowLaneBehavior(6) for 2 seconds
    do LaneChangeBehavior(laneSectionToSwitch=target, target_speed=6)
    do FollowLaneBehavior(6)
sections = filter(lambda s: s._fasterLane is not None and s.centerline.length > 100, network.laneSections)
section = Uniform(*sections)
ego = new Car on section.centerline, with behavior Change(section._fasterLane)
