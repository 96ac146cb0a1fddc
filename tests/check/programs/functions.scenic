param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

def suitable(section):
    return section.centerline.length > 60 and section.isForward
def ahead_of(obj, low, high):
    return new OrientedPoint following roadDirection from obj for Range(low, high)
places = [s for s in network.laneSections if suitable(s)]
ego = new Car on Uniform(*places).centerline
spots = ahead_of(ego, 10, 15)
lead = new Car at spots
