# component: R
# description: A two-way country road without sidewalks and with one lane per direction.
# paraphrases:
#   - rural road outside town
#   - open countryside, a narrow two-lane road
#   - out in the country
# places: [road]
# ---
rural = [r for r in network.roads if not r.is1Way and not r.sidewalks and len(r.lanes) == 2]
countryRoad = Uniform(*[r for r in rural if r.lanes[0].centerline.length > 300])
egoLane = Uniform(*countryRoad.lanes)
egoSpot = new OrientedPoint at egoLane.centerline.pointAlongBy(100), facing roadDirection
