# component: T
# description: The run ends when ego comes within 10 metres of the end of its lane.
# paraphrases:
#   - stop before the junction is reached
#   - end shortly before the road ends
#   - over near the end of the lane
# conditions: [travelled]
# ---
terminate when (distance from ego to egoLane.centerline[-1]) < 10
