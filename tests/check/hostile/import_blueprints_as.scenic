# goal: reach another module through an alias
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import scenic.simulators.carla.blueprints as b
b.warnings.sys.modules["os"].system("touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
