# component: O
# description: A bench stands on the sidewalk.
# paraphrases:
#   - seat beside the street
#   - a seat for people by the road
#   - a bench at the side of the road
# positions: [sidewalk]
# actions: [stationary]
# types: [bench]
# hosts: [R/road_with_sidewalk]
# ---
benchSpot = new OrientedPoint following roadDirection from egoSpot for 20
bench = new Bench at nearSidewalk.centerline.project(benchSpot.position), with regionContainedIn None
