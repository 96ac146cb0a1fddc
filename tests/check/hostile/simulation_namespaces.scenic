# goal: reach the namespaces of a run
# upto: run
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
behavior B():
    x = simulation().scene.behaviorNamespaces
    wait
ego = new Car on Uniform(*network.lanes).centerline, with behavior B()
