# component: O
# description: A bus stop shelter stands on the sidewalk on the right.
# paraphrases:
#   - passengers' shelter at the pavement
#   - people wait under a roof for the bus
#   - a bus stop at the side of the road
# positions: [sidewalk]
# actions: [stationary]
# types: [bus_stop]
# ---
shelterSpot = new OrientedPoint following roadDirection from egoSpot for 25
shelter = new BusStop right of shelterSpot by 6.5, facing 90 deg relative to shelterSpot.heading,
    with regionContainedIn None
