# goal: write a file
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
with open("MARK", "w") as f:
    f.write("x")
ego = new Car on Uniform(*network.lanes).centerline
