# goal: flood the output
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
while True:
    print("x" * 100000)
ego = new Car on Uniform(*network.lanes).centerline
