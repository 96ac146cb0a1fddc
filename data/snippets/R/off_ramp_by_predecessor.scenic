# component: R
# description: Ego drives on the motorway 100 metres before an off-ramp begins.
# paraphrases:
#   - just ahead of the slip road that leads off the motorway
#   - on the highway shortly before the exit
#   - the exit from the freeway comes up
# places: [off_ramp]
# ---
rampStarts = [m for i in network.intersections for m in i.maneuvers if len(m.endLane.road.lanes) == 1 and m.endLane.road.is1Way and len(m.startLane.road.lanes) > 2]
exitWay = Uniform(*rampStarts)
egoLane = exitWay.startLane
rampLane = exitWay.endLane
egoPath = [egoLane, exitWay.connectingLane, rampLane]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(egoLane.centerline.length - 100), facing roadDirection
