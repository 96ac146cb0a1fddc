# component: R
# description: A two-way road without a divider, so that an oncoming lane lies directly left of ego's lane.
# paraphrases:
#   - undivided road with opposing traffic right next to ego
#   - no median between the directions of travel
#   - traffic comes the other way right next to us
# places: [road]
# ---
undivided = [s for s in network.laneSections if s._laneToLeft and s._laneToLeft.isForward != s.isForward]
egoSection = Uniform(*[s for s in undivided if s.centerline.length > 180])
egoLane = egoSection.lane
oncomingLane = egoSection._laneToLeft.lane
egoSpot = new OrientedPoint at egoSection.centerline.pointAlongBy(50), facing roadDirection
