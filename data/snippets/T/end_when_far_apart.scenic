# component: T
# description: The run ends when ego and the other vehicle are over 70 metres apart.
# paraphrases:
#   - finish when they have separated
#   - end when the cars are far from each other
#   - over when the other car is far away
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate when (distance from ego to lead) > 70
