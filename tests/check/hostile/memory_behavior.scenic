# goal: fill memory in a behavior
# upto: run
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
behavior B():
    x = [0] * (10 ** 11)
    wait
ego = new Car on Uniform(*network.lanes).centerline, with behavior B()
