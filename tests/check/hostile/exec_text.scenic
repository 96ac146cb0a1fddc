# goal: execute text
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
exec("import os; os.system('touch MARK')")
ego = new Car on Uniform(*network.lanes).centerline
