# goal: copy a file
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import shutil
shutil.copy("SECRET", "MARK")
ego = new Car on Uniform(*network.lanes).centerline
