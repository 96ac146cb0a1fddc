# component: T
# description: The whole simulation ends when either 20 seconds are over or the vehicles are 80 metres apart.
# paraphrases:
#   - two alternative ends
# conditions: [time, distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate simulation when simulation().currentTime > 200
terminate simulation when (distance from ego to lead) > 80
