# component: T
# description: In four of five scenes the gap is less than 30 metres (a soft requirement).
# paraphrases:
#   - usually close, not always
#   - the cars are mostly near each other
#   - a rule that holds most of the time
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require[0.8] (distance from ego to lead) < 30
