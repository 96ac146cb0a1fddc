# goal: reach the namespace of the module
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = _Scenic_module_namespace["__builtins__"]
ego = new Car on Uniform(*network.lanes).centerline
