# component: T
# description: At the start the distance between ego and the lead vehicle lies between 10 and 40 metres.
# paraphrases:
#   - initial gap within bounds
#   - starting separation limited on both sides
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require 10 < (distance from ego to lead) < 40
