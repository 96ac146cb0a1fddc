# goal: never end in a monitor
# upto: run
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
monitor M():
    while True:
        x = 1
    wait
require monitor M()
ego = new Car on Uniform(*network.lanes).centerline
