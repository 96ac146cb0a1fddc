# component: T
# description: The other vehicle is visible and no farther than 50 metres.
# paraphrases:
#   - seen and near
# conditions: [visible, distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require (ego can see lead) and (distance from ego to lead) < 50
