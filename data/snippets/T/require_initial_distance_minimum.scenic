# component: T
# description: At the start the vehicles are at least 8 metres apart.
# paraphrases:
#   - minimum headway in the first scene
#   - the cars do not start too close together
#   - some room between the cars at the beginning
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
MINIMUM_GAP = 8
require (distance from ego to lead) >= MINIMUM_GAP
