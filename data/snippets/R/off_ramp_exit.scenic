# component: R
# description: Ego is in the lane of a motorway from which the exit ramp branches off, and takes the exit.
# paraphrases:
#   - leave the freeway at the next exit
#   - highway exit lane
#   - slip road that leads off the highway
# places: [off_ramp]
# ---
diverges = [m for i in network.intersections for m in i.maneuvers if m.startLane.road.is1Way and len(m.startLane.road.lanes) >= 2]
exits = filter(lambda m: m.endLane.road.is1Way and len(m.endLane.road.lanes) == 1, diverges)
egoManeuver = Uniform(*exits)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -150
