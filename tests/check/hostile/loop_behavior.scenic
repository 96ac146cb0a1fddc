# goal: never end in a behavior
# upto: run
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
behavior B():
    while True:
        x = 1
ego = new Car on Uniform(*network.lanes).centerline, with behavior B()
