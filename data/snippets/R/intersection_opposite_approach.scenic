# component: R
# description: A crossroads with the lane of the opposite approach (reverse manoeuvre) at hand for oncoming vehicles.
# paraphrases:
#   - junction where somebody comes towards ego from the far side
#   - a crossroads where traffic comes from the other side
#   - oncoming cars at the junction
# places: [intersection]
# ---
withReverse = [m for i in network.intersections if i.is4Way for m in i.maneuvers if m.type is ManeuverType.STRAIGHT and m.reverseManeuvers]
egoManeuver = Uniform(*withReverse)
oppositeManeuver = Uniform(*egoManeuver.reverseManeuvers)
egoLane = egoManeuver.startLane
egoPath = [egoManeuver.startLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint following roadDirection from egoLane.centerline[-1] for -35
