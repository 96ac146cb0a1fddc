# component: T
# description: The whole simulation ends when either 20 seconds are over or the vehicles are 80 metres apart.
# paraphrases:
#   - two alternative ends
#   - end after a time or when the cars are far apart
#   - two conditions, the first one ends it
# conditions: [time, distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
terminate simulation when simulation().currentTime > 200
terminate simulation when (distance from ego to lead) > 80
