# goal: never end in a property default
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
def f():
    while True:
        pass
class Slow(Car):
    width: f()
ego = new Slow on road
