# goal: never end and catch what would end it
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
while True:
    try:
        while True:
            pass
    except Exception:
        pass
ego = new Car on Uniform(*network.lanes).centerline
