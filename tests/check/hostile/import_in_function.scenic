# goal: import inside a function
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f():
    from os import system
    return system("touch MARK")
x = f()
ego = new Car on Uniform(*network.lanes).centerline
