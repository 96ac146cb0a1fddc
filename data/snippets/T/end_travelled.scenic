# component: T
# description: The run ends when ego has travelled 80 metres from its start.
# paraphrases:
#   - stop after a given distance
#   - finish once the car has covered its stretch
#   - stop after so many metres
# conditions: [travelled]
# ---
terminate when (distance from ego to egoSpot) > 80
