# component: T
# description: The run ends when ego enters the intersection.
# paraphrases:
#   - stop at the moment the junction is reached
#   - end when my car reaches the crossroads
#   - over when it drives into the junction
# conditions: [action]
# hosts: [R/intersection_four_way]
# ---
terminate when ego in egoManeuver.intersection
