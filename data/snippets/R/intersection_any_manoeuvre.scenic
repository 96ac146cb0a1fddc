# component: R
# description: 'Any way through any intersection: ego may turn or go straight.'
# paraphrases:
#   - random junction, random direction
#   - some junction, turning or not
#   - any crossing, whichever way the car goes
# places: [intersection]
# ---
junction = Uniform(*network.intersections)
egoManeuver = Uniform(*junction.maneuvers)
egoLane = egoManeuver.startLane
egoPath = [egoLane, egoManeuver.connectingLane, egoManeuver.endLane]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(0.6 * egoLane.centerline.length), facing roadDirection
