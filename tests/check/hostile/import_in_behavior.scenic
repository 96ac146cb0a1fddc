# goal: import inside a behavior
# upto: run
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
behavior B():
    import os
    os.system("touch MARK")
    wait
ego = new Car on Uniform(*network.lanes).centerline, with behavior B()
