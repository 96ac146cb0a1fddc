# component: R
# description: Ego starts on an entry ramp, 60 to 150 metres before it meets the motorway.
# paraphrases:
#   - ramp that leads up to the freeway
#   - slip road, about to merge
#   - slip road that leads onto the highway
# places: [on_ramp]
# ---
rampLanes = [l for l in network.lanes if l.road.is1Way and len(l.road.lanes) == 1 and l.centerline.length > 200 and l.maneuvers and len(l.maneuvers[0].endLane.road.lanes) >= 3]
egoLane = Uniform(*rampLanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(egoLane.centerline.length - Range(60, 150)), facing roadDirection
