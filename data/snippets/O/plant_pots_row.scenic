# component: O
# description: Plant pots stand in a row along the right edge of the road.
# paraphrases:
#   - flower tubs beside the lane
#   - big flower pots along the road
#   - a line of planters at the side of the road
# positions: [roadside]
# actions: [stationary]
# types: [plant_pot]
# ---
potSpot = new OrientedPoint following roadDirection from egoSpot for 20
for k in range(3):
    new PlantPot right of (potSpot offset by (0, 5 * k)) by 3, with regionContainedIn None
