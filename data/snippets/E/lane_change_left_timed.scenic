# component: E
# description: Ego changes one lane to the left two seconds after the start and stays there.
# paraphrases:
#   - driver-initiated lane change to the passing lane
#   - move over to the inner lane on its own
#   - move over to the left
# actions: [lane_change]
# hosts: [R/road_two_lanes_same_direction]
# ---
targetSection = network.laneSectionAt(egoSpot).laneToLeft

behavior EgoChangesLeft(speed):
    do FollowLaneBehavior(target_speed=speed) for 2 seconds
    do LaneChangeBehavior(targetSection, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed, laneToFollow=targetSection.lane)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoChangesLeft(8)
