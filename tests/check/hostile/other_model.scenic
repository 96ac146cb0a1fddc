# goal: run another module as world model
# upto: sample
param map = localPath('town.xodr')
model antigravity
ego = new Car on Uniform(*network.lanes).centerline
