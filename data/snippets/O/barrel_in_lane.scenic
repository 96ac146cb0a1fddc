# component: O
# description: A barrel stands in ego's lane.
# paraphrases:
#   - drum on the path
#   - a barrel or drum in my way
#   - a keg stands on the road in front of me
# positions: [ahead]
# actions: [stationary]
# types: [barrel]
# ---
barrel = new Barrel at egoSpot offset by (0, Range(35, 45)), with regionContainedIn None
