# component: R
# description: A motorway with three lanes per direction; ego is in the middle lane.
# paraphrases:
#   - three-lane highway, start in the centre
#   - freeway with neighbours on both sides
#   - highway with a lane on either side
# places: [motorway]
# ego_lanes: [middle]
# ---
motorways = [r for r in network.roads if r.is1Way and len(r.lanes) >= 3 and not r.sidewalks]
egoLane = Uniform(*[r.lanes[1] for r in motorways if r.lanes[1].centerline.length > 500])
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(Range(150, 250)), facing roadDirection
