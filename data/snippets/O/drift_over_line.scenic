# component: O
# description: A car in the left lane drifts slowly towards ego's lane and stays over the line.
# paraphrases:
#   - inattentive neighbour slides across the marking
#   - gradual lane departure next to the host
#   - a car next to me wanders over the line
# positions: [left_lane]
# actions: [drift]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
driftSpot = new OrientedPoint following roadDirection from egoSpot for 6

behavior DriftsRight(speed):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    while True:
        take SetThrottleAction(0.35 if self.speed < speed else 0), SetSteerAction(0.02)

drifter = new Car left of driftSpot by 2.6, facing roadDirection, with behavior DriftsRight(9)
