# component: R
# description: A mid-block crosswalk 40 to 60 metres ahead of ego on a street with sidewalks, far from any junction.
# paraphrases:
#   - pedestrian crossing in the middle of the block
#   - crosswalk without lights between two junctions
# places: [crosswalk]
# ---
streets = filter(lambda g: g._sidewalk is not None and g.lanes[0].centerline.length > 250, network.laneGroups)
egoLane = Uniform(*streets).lanes[0]
crosswalkSpot = new OrientedPoint on egoLane.centerline, facing roadDirection
egoSpot = new OrientedPoint following roadDirection from crosswalkSpot for -Range(40, 60)
require (distance from crosswalkSpot to intersection) > 70
require (distance from crosswalkSpot to egoLane.centerline[0]) > 80
