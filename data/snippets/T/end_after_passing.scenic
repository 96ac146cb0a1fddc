# component: T
# description: The run ends when ego is 10 metres ahead of the other vehicle.
# paraphrases:
#   - over once the overtaking is complete
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate when (distance past lead of ego) > 10
