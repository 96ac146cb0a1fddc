# component: O
# description: Three parked cars stand in a row at the right kerb.
# paraphrases:
#   - line of vehicles beside the road
#   - kerb full of standing cars
#   - cars parked along the street
# positions: [parked]
# actions: [stationary]
# types: [car]
# hosts: [R/road_with_parking_lane]
# ---
rowStart = new OrientedPoint following roadDirection from egoSpot for 20
rowA = new Car right of rowStart by 2.2, facing roadDirection, with regionContainedIn None
rowB = new Car ahead of rowA by 1.5, with regionContainedIn None
rowC = new Car ahead of rowB by 1.5, with regionContainedIn None
