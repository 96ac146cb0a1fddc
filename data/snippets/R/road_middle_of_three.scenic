# component: R
# description: A road on which ego has a lane of its own direction on both sides.
# paraphrases:
#   - neighbours left and right, both driving the same way
#   - a lane to the left and another to the right
# places: [road]
# ego_lanes: [middle]
# ---
between = [s for s in network.laneSections if s._laneToLeft and s._laneToRight and s._laneToLeft.isForward == s.isForward and s._laneToRight.isForward == s.isForward]
egoSection = Uniform(*filter(lambda s: s.centerline.length > 300, between))
egoLane = egoSection.lane
leftLane, rightLane = egoSection._laneToLeft, egoSection._laneToRight
egoSpot = new OrientedPoint at egoSection.centerline.pointAlongBy(120), facing roadDirection
