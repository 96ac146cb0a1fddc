# goal: run a command
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
import subprocess
subprocess.run(["touch", "MARK"])
ego = new Car on Uniform(*network.lanes).centerline
