# component: T
# description: Ego can see the other vehicle at the start.
# paraphrases:
#   - target in the field of view
#   - line of sight is free
#   - in sight at the beginning
# conditions: [visible]
# hosts: [O/lead_ahead_of_specifier]
# ---
require ego can see lead
