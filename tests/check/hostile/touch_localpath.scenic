# goal: make a file through the path object that localPath gives
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
localPath("MARK").touch()
ego = new Car on Uniform(*network.lanes).centerline
