# component: E
# description: Ego leaves the left lane for the lane to its right after a few seconds.
# paraphrases:
#   - return to the slow lane
#   - keep-right manoeuvre
#   - move over to the right
# actions: [lane_change]
# hosts: [R/road_left_of_two_lanes]
# ---
rightSection = egoSection.laneToRight

behavior EgoChangesRight(speed, delay):
    do FollowLaneBehavior(speed) for delay seconds
    do LaneChangeBehavior(rightSection, target_speed=speed)
    do FollowLaneBehavior(speed, laneToFollow=rightSection.lane)

ego = new Car at egoSpot, facing roadDirection, with behavior EgoChangesRight(8, Range(1, 3))
