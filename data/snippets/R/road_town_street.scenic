# component: R
# description: A two-way town street with one lane per direction and a sidewalk on ego's side.
# paraphrases:
#   - an urban road, single lane each way, with a pavement next to it
#   - inner-city two-lane street where pedestrians may walk beside the traffic
# places: [road]
# ---
streetGroups = [g for g in network.laneGroups if len(g.lanes) == 1 and g._opposite and g._sidewalk]
streetGroup = Uniform(*[g for g in streetGroups if g.lanes[0].centerline.length > 150])
egoLane = streetGroup.lanes[0]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(Range(30, 60)), facing roadDirection
