# component: T
# description: Ego starts at most 60 metres from the intersection that it approaches.
# paraphrases:
#   - junction close by at the start
#   - my car starts near a junction
#   - begin close to the crossroads
# conditions: [distance]
# hosts: [R/intersection_four_way]
# ---
require (distance from ego to egoManeuver.intersection) < 60
