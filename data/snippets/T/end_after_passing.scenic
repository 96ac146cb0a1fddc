# component: T
# description: The run ends when ego is 10 metres ahead of the other vehicle.
# paraphrases:
#   - over once the overtaking is complete
#   - end when my car has passed the other one
#   - finished once it is in front of the other car
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate when (distance past lead of ego) > 10
