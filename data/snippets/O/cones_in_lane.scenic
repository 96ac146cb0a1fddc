# component: O
# description: A row of four traffic cones stands across ego's lane.
# paraphrases:
#   - coned-off carriageway
#   - pylons block the path
#   - traffic cones across my lane
# positions: [ahead]
# actions: [stationary]
# types: [cone]
# ---
coneRow = new OrientedPoint following roadDirection from egoSpot for 45
coneA = new Cone at coneRow offset by (-1.5, 0), with regionContainedIn None
coneB = new Cone at coneRow offset by (-0.5, 0.5), with regionContainedIn None
coneC = new Cone at coneRow offset by (0.5, 1), with regionContainedIn None
coneD = new Cone at coneRow offset by (1.5, 1.5), with regionContainedIn None
