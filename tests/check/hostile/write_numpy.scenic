# goal: write a file through a leaked numpy
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
np.save("MARK", np.zeros(3))
ego = new Car on Uniform(*network.lanes).centerline
