# goal: fetch an address
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
from urllib.request import urlopen
x = urlopen("http://127.0.0.1:PORT/").read()
ego = new Car on Uniform(*network.lanes).centerline
