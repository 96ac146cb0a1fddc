# component: O
# description: A car circulates in the roundabout and comes from the left as ego arrives.
# paraphrases:
#   - traffic already in the rotary has priority
#   - a car is already in the roundabout
#   - a car drives round the circle and comes from my left
# positions: [circulating]
# actions: [keep_lane]
# types: [car]
# hosts: [R/roundabout_entry]
# ---
ringCars = filter(lambda l: l.road.is1Way and len(l.road.lanes) == 1 and 15 < l.centerline.length < 60, network.lanes)
ringLane = Uniform(*ringCars)
circulating = new Car on ringLane.centerline, facing roadDirection,
    with behavior FollowLaneBehavior(target_speed=5)
require 10 < (distance from circulating to ego) < 110
