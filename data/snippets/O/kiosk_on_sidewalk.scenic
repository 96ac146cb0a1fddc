# component: O
# description: A kiosk stands at the sidewalk and blocks the view of it.
# paraphrases:
#   - newsstand at the street
#   - a small shop at the roadside hides what is behind it
#   - a newspaper stand at the side of the road
# positions: [sidewalk]
# actions: [stationary]
# types: [kiosk]
# ---
kioskSpot = new OrientedPoint following roadDirection from egoSpot for 22
kiosk = new Kiosk right of kioskSpot by 7, with regionContainedIn None
