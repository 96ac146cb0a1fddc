# component: T
# description: At the start the vehicles are at least 8 metres apart.
# paraphrases:
#   - minimum headway in the first scene
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
MINIMUM_GAP = 8
require (distance from ego to lead) >= MINIMUM_GAP
