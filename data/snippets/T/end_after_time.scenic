# component: T
# description: The run ends after 15 seconds.
# paraphrases:
#   - stop the simulation after a quarter of a minute
#   - fixed duration
#   - time limit
# conditions: [time]
# ---
terminate after 15 seconds
