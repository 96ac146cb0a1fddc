# goal: import a module by calling the machinery of the model statement
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
d = {}
model(d, "os")
d["system"]("touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
