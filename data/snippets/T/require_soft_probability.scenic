# component: T
# description: In four of five scenes the gap is less than 30 metres (a soft requirement).
# paraphrases:
#   - usually close, not always
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require[0.8] (distance from ego to lead) < 30
