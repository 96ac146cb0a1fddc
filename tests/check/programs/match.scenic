param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

mode = 'calm'
match mode:
    case 'calm':
        top = 5
    case _:
        top = 9
ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(top)
name = f'{mode}-{top:>3}'
