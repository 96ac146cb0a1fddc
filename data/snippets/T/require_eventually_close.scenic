# component: T
# description: At some time of the run ego must have come within 60 metres of the lead vehicle.
# paraphrases:
#   - an encounter has to happen
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require eventually (distance from ego to lead) < 60
