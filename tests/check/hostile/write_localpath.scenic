# goal: write a file through the path object that localPath gives
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
localPath("MARK").write_text("x")
ego = new Car on Uniform(*network.lanes).centerline
