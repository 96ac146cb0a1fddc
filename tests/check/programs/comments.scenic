param map = localPath('town.xodr')
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model

# a comment before everything


ego = new Car on Uniform(*network.lanes).centerline  # ego stands

"""text in between
# not a comment
"""
behavior Idle():
    # only waits

    while True:

        wait
other = new Car following roadDirection from ego for Range(10, 20), \
    with behavior Idle()
    # an indented comment
# the last comment
