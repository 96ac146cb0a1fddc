# component: O
# description: 'A work zone beside the lane: cones along the right edge over 15 metres and a sign before them.'
# paraphrases:
#   - roadside works that leave the lane open
#   - roadworks next to the lane
#   - road works at the side, my lane stays free
# positions: [roadside]
# actions: [stationary]
# types: [construction_zone]
# ---
siteSpot = new OrientedPoint following roadDirection from egoSpot for 30
siteSign = new TrafficWarning right of siteSpot by 2.5, facing 180 deg relative to siteSpot.heading, with regionContainedIn None
for distance_along in (6, 11, 16, 21):
    new Cone at siteSpot offset by (2.1, distance_along), with regionContainedIn None
