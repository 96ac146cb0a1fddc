# component: O
# description: A van is parked somewhere on the shoulder beside ego's road.
# paraphrases:
#   - delivery van at the edge of the street
#   - a van parked at the side
#   - a parked van beside the road
# positions: [parked]
# actions: [stationary]
# types: [van]
# hosts: [R/road_with_parking_lane]
# ---
parkedVan = new Van on parkingStrip, facing roadDirection, with regionContainedIn None
require 15 < (distance from parkedVan to ego) < 90
