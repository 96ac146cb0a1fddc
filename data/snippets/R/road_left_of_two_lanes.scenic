# component: R
# description: A road with at least two lanes in ego's direction; ego is in the leftmost one.
# paraphrases:
#   - the vehicle under test occupies the inner, fast lane
#   - start in the passing lane of a multi-lane road
# places: [road]
# ego_lanes: [leftmost]
# ---
sections = [s for s in network.laneSections if s._laneToRight and s.lane.centerline.length > 220]
passing = filter(lambda s: s._laneToLeft is None or s._laneToLeft.isForward != s.isForward, sections)
egoSection = Uniform(*passing)
egoLane = egoSection.lane
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(70), facing roadDirection
