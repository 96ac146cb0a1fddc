# goal: import by the builtin
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = __import__("os").system("touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
