# goal: reach os through attributes of a package
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import scenic.syntax.translator
scenic.syntax.translator.os.system("touch MARK")
ego = new Car on Uniform(*network.lanes).centerline
