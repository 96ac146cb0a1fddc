# component: E
# description: Ego changes to the left lane and, three seconds later, back to its own.
# paraphrases:
#   - out and in again
#   - double lane change
#   - my car moves one lane to the left and returns
# actions: [lane_change]
# hosts: [R/road_two_lanes_same_direction]
# ---
ownSection = network.laneSectionAt(egoSpot)

behavior EgoChangesAndReturns(speed):
    do FollowLaneBehavior(target_speed=speed) for 1 seconds
    do LaneChangeBehavior(ownSection.laneToLeft, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed) for 3 seconds
    do LaneChangeBehavior(ownSection, target_speed=speed)
    do FollowLaneBehavior(target_speed=speed)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoChangesAndReturns(8)
