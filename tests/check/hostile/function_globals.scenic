# goal: reach the globals of a library function
# upto: sample
param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
x = FollowLaneBehavior.__init__.__globals__["__builtins__"]["open"]("MARK", "w")
ego = new Car on Uniform(*network.lanes).centerline
