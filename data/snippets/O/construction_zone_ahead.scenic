# component: O
# description: 'A work zone closes ego''s lane: a warning sign, four cones and a barrier.'
# paraphrases:
#   - construction site on the lane
#   - road works with signage
#   - roadworks in my lane
#   - my side of the road is dug up
# positions: [ahead]
# actions: [stationary]
# types: [construction_zone, warning_sign]
# ---
zoneSpot = new OrientedPoint following roadDirection from egoSpot for 60
zoneSign = new TrafficWarning at zoneSpot offset by (2.4, -12), facing 180 deg relative to zoneSpot.heading, with regionContainedIn None
zoneBarrier = new Barrier at zoneSpot, facing 90 deg relative to zoneSpot.heading, with regionContainedIn None
zoneConeA = new Cone at zoneSpot offset by (-1.4, -4), with regionContainedIn None
zoneConeB = new Cone at zoneSpot offset by (1.4, -4), with regionContainedIn None
zoneConeC = new Cone at zoneSpot offset by (-1.4, 4), with regionContainedIn None
zoneConeD = new Cone at zoneSpot offset by (1.4, 4), with regionContainedIn None
