# component: T
# description: The run ends when the simulated time exceeds 12 seconds, counted in steps of a tenth of a second.
# paraphrases:
#   - time-out by step count
#   - time limit
# conditions: [time]
# ---
terminate when simulation().currentTime > 120
