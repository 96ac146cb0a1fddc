# component: O
# description: An animal stands still on the lane ahead of ego.
# paraphrases:
#   - cow blocks the road
#   - deer frozen in the headlights
#   - a cow or deer stands in my way
# positions: [ahead]
# actions: [stationary]
# types: [animal]
# ---
animalSpot = new OrientedPoint following roadDirection from egoSpot for Range(35, 45)
animal = new Pedestrian at animalSpot, facing 90 deg relative to egoSpot.heading,
    with rolename 'animal', with regionContainedIn None
