# component: T
# description: At some time of the run ego must have come within 60 metres of the lead vehicle.
# paraphrases:
#   - an encounter has to happen
#   - my car must get near the other one at some time
#   - the cars have to meet sooner or later
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require eventually (distance from ego to lead) < 60
