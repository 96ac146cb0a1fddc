# goal: call the C library
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import ctypes
ctypes.CDLL(None).system(b"touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
