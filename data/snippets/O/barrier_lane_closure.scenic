# component: O
# description: Barriers and cones close ego's lane.
# paraphrases:
#   - lane blocked for road works
#   - the lane ends at a barricade
#   - my side of the road is closed by workmen
# positions: [ahead]
# actions: [stationary]
# types: [lane_closure, barrier]
# ---
closureSpot = new OrientedPoint following roadDirection from egoSpot for 55
closureBarrier = new Barrier at closureSpot, facing 90 deg relative to closureSpot.heading, with regionContainedIn None
closureCones = [new Cone at closureSpot offset by (dx, -6), with regionContainedIn None for dx in (-1.2, 0, 1.2)]
