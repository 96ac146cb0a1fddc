# component: T
# description: The other vehicle is visible and no farther than 50 metres.
# paraphrases:
#   - seen and near
#   - the other car can be seen and is near
#   - my car has a clear view of the other one
# conditions: [visible, distance]
# hosts: [O/lead_ahead_of_specifier]
# ---
require (ego can see lead) and (distance from ego to lead) < 50
