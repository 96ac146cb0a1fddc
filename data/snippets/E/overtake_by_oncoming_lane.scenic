# component: E
# description: Ego passes an obstacle through the lane of the oncoming traffic and returns to its own lane.
# paraphrases:
#   - use the opposite lane to get round a blockage
#   - two-way road detour
#   - get past something on the other side of the road
# actions: [overtake]
# hosts: [R/road_oncoming_lane_adjacent]
# ---
behavior EgoPassesByOncoming(speed):
    try:
        do FollowLaneBehavior(target_speed=speed)
    interrupt when withinDistanceToObjsInLane(self, 18):
        do LaneChangeBehavior(egoSection.laneToLeft, is_oppositeTraffic=True, target_speed=speed)
        do FollowLaneBehavior(target_speed=speed, is_oppositeTraffic=True) for 3 seconds
        do LaneChangeBehavior(egoSection, target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoPassesByOncoming(7)
