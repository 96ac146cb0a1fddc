# component: O
# description: A cyclist rides straight on beside ego while ego turns right.
# paraphrases:
#   - nearside turn across a bike
#   - right hook
#   - a cyclist beside me while I turn right
# positions: [right_lane]
# actions: [go_straight, move_along]
# types: [bicycle]
# hosts: [R/intersection_right_turn]
# ---
hookSpot = new OrientedPoint following roadDirection from egoSpot for 4

behavior RidesOn(throttle):
    while True:
        take SetThrottleAction(throttle), SetSteerAction(0)

hookedBike = new Bicycle right of hookSpot by 2.4, facing roadDirection,
    with regionContainedIn None,
    with behavior RidesOn(0.5)
