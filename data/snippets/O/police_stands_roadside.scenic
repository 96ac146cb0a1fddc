# component: O
# description: A police car stands at the roadside on the right.
# paraphrases:
#   - patrol vehicle beside the carriageway
#   - police officers wait at the side of the road
#   - a police car is parked at the side of the road
# positions: [roadside]
# actions: [stationary]
# types: [police_car]
# hosts: [R/road_with_parking_lane]
# ---
patrolSpot = new OrientedPoint following roadDirection from egoSpot for 30
patrol = new Car right of patrolSpot by 2.3, facing roadDirection,
    with blueprint 'vehicle.dodge.charger_police', with regionContainedIn None
