# goal: read a file as a mesh
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
s = MeshShape.fromFile("SECRET")
ego = new Car on Uniform(*network.lanes).centerline
