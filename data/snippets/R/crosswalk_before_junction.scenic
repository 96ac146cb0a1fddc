# component: R
# description: 'A crossing place for pedestrians: ego approaches a point of its lane, between two sidewalks, where people cross.'
# paraphrases:
#   - zebra crossing on ego's way
#   - the car drives up to where walkers cross the street
#   - zebra crossing in front
# places: [crosswalk]
# ---
bothSides = [g for g in network.laneGroups if g._sidewalk and g._opposite and g._opposite._sidewalk and g.lanes[0].centerline.length > 200]
crossingGroup = Uniform(*bothSides)
egoLane = crossingGroup.lanes[0]
crosswalkSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(120), facing roadDirection
egoSpot = new OrientedPoint following roadDirection from crosswalkSpot for -50
