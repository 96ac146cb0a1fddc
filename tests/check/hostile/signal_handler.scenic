# goal: take over signals
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import signal
signal.alarm(0)
ego = new Car on Uniform(*network.lanes).centerline
