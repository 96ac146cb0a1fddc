# component: T
# description: The run ends when ego has reached the lane to its left.
# paraphrases:
#   - over when the lane change is complete
#   - end when my car is in the left lane
#   - finished after moving over one lane
# conditions: [action]
# hosts: [R/road_two_lanes_same_direction]
# ---
goalSection = network.laneSectionAt(egoSpot).laneToLeft
terminate when ego in goalSection
