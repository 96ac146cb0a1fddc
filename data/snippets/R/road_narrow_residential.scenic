# component: R
# description: 'A quiet residential lane: narrow lanes, sidewalk, no parking strip.'
# paraphrases:
#   - housing estate, a 30 zone with little width
#   - a narrow street in a residential area
#   - a small street between houses
# places: [road]
# ---
narrow = filter(lambda g: g._sidewalk is not None and g._shoulder is None and len(g.lanes) == 1, network.laneGroups)
egoGroup = Uniform(*filter(lambda g: g.lanes[0].centerline.length > 120, narrow))
egoLane = egoGroup.lanes[0]
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(40), facing roadDirection
