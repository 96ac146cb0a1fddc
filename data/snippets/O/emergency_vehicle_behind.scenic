# component: O
# description: An ambulance comes fast from behind in the left lane and passes ego.
# paraphrases:
#   - emergency vehicle wants to get by
#   - rescue service rushes past
#   - paramedics with siren come up from behind
#   - a rescue vehicle wants to get through
# positions: [behind]
# actions: [overtake]
# types: [ambulance]
# hosts: [R/road_two_lanes_same_direction]
# ---
sirenSpot = new OrientedPoint following roadDirection from egoSpot for -30
ambulance = new Car left of sirenSpot by 2.5, facing roadDirection,
    with blueprint 'vehicle.ford.ambulance',
    with behavior FollowLaneBehavior(target_speed=17)
