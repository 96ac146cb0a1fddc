# goal: never end in a specifier
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f():
    n = 0
    while True:
        n = n + 1
    return n
ego = new Car on road, with width f()
