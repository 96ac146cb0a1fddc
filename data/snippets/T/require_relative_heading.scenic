# component: T
# description: Both vehicles point the same way at the start, within 10 degrees.
# paraphrases:
#   - aligned with each other
#   - both cars face the same way
#   - the cars point in the same direction at the start
# conditions: [distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require abs(relative heading of lead from ego) < 10 deg
