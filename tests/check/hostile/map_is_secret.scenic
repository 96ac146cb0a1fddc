# goal: read a file as a map
# upto: sample
param map = 'SECRET'
model scenic.simulators.carla.model
ego = new Car on Uniform(*network.lanes).centerline
