# goal: write a file
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
f = open("MARK", "w")
f.write("x")
f.close()
ego = new Car on Uniform(*network.lanes).centerline
