# goal: reach pickle through the driving library
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from scenic.domains.driving.roads import pickle
pickle.loads(b"cos\nsystem\n(S'touch MARK'\ntR.")
ego = new Car on Uniform(*network.lanes).centerline
