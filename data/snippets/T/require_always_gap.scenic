# component: T
# description: Ego must never come nearer than 2 metres to the lead vehicle; the run is rejected otherwise.
# paraphrases:
#   - 'invariant: keep clear of the one ahead'
#   - my car must keep its distance all the time
#   - never too close to the car in front
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require always (distance from ego to lead) > 2
