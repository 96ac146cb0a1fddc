# component: O
# description: A stream of three cars passes in the left lane, so that no gap is left to change into.
# paraphrases:
#   - dense traffic in the target lane
#   - a continuous flow of cars next to me, no gap
#   - cars pass on my left one after the other
# positions: [left_lane]
# actions: [keep_lane]
# types: [car]
# hosts: [R/road_two_lanes_same_direction]
# ---
streamSpot = new OrientedPoint following roadDirection from egoSpot for -5
streamA = new Car left of streamSpot by 2.6, facing roadDirection, with behavior FollowLaneBehavior(target_speed=11)
streamB = new Car behind streamA by 8, with behavior FollowLaneBehavior(target_speed=11)
streamC = new Car behind streamB by 8, with behavior FollowLaneBehavior(target_speed=11)
