# component: T
# description: Ego starts at least 30 metres away from any intersection.
# paraphrases:
#   - keep clear of junctions at the beginning
#   - my car starts far from any junction
#   - no crossroads nearby at the beginning
# conditions: [distance]
# ---
require (distance from ego to intersection) > 30
