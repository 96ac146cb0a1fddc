# component: T
# description: The run ends when ego is 60 metres further on, measured past its starting point along its first heading.
# paraphrases:
#   - finish line down the road
#   - end after a certain distance driven
#   - over when my car has driven that many metres
# conditions: [travelled]
# ---
finishLine = new OrientedPoint following roadDirection from egoSpot for 60
terminate when (distance past finishLine of ego) > 0
