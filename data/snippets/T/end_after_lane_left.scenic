# component: T
# description: The run ends when ego has left the lane that it started in.
# paraphrases:
#   - stop at a lane departure
#   - over when my car leaves its lane
#   - end as soon as the car is out of its lane
# conditions: [action]
# ---
terminate when not (ego in egoLane) and simulation().currentTime > 5
