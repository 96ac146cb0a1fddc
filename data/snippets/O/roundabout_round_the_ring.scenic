# component: O
# description: A van that is already in the roundabout keeps going round and passes ego's entry without slowing down.
# paraphrases:
#   - somebody on the circle drives past the mouth of my road
#   - a vehicle in the ring has the right of way over me
#   - a van goes round the rotary in front of me
# places: [roundabout]
# positions: [circulating]
# actions: [keep_lane]
# types: [van]
# hosts: [R/roundabout_by_ring_roads]
# ---
behavior GoesRound():
    try:
        do FollowLaneBehavior(target_speed=6)
    interrupt when self.lane.road not in ringRoads:
        do FollowLaneBehavior(target_speed=8)
onRing = new Van on Uniform(*ringRoads).lanes[0].centerline, facing roadDirection, with behavior GoesRound()
require 8 < (distance from onRing to egoSpot) < 100
