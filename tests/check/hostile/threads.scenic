# goal: make threads without end
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from threading import Thread
while True:
    Thread(target=print).start()
ego = new Car on Uniform(*network.lanes).centerline
