# goal: write a file through a module that the model leaks
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
pathlib.Path("MARK").write_text("x")
ego = new Car on Uniform(*network.lanes).centerline
