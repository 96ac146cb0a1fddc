# goal: load a pickle through a leaked numpy
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = np.load("SECRET", allow_pickle=True)
ego = new Car on Uniform(*network.lanes).centerline
