# goal: import in an f-string
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = f"{__import__('os').getcwd()}"
ego = new Car on Uniform(*network.lanes).centerline
