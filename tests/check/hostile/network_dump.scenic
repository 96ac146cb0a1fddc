# goal: write a pickle of the network
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
network.dumpPickle("MARK", b"", b"")
ego = new Car on Uniform(*network.lanes).centerline
