# goal: climb frames from an exception
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
try:
    x = 1 / 0
except ZeroDivisionError as e:
    y = e.__traceback__.tb_frame.f_globals
ego = new Car on Uniform(*network.lanes).centerline
