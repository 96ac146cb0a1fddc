# goal: open a connection
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import socket
s = socket.create_connection(("127.0.0.1", PORT))
ego = new Car on Uniform(*network.lanes).centerline
